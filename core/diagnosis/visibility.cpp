#include "core/diagnosis/visibility.h"

#include <algorithm>

#include "core/diagnosis/inquiry.h"
#include "core/diagnosis/look_alikes.h"

namespace alidade {

Result<Visibility> visibilityOf(const Measurement& noiseless, const std::string& held) {
  const Result<GapModel> model = modelOf(noiseless);
  if (!model) return model.problem();
  const Leftover leftover(linearise(model->measurement, model->fit, model->options), model->options.terms);
  const Eigen::VectorXd& trace = leftover.residual();
  Visibility visibility{.sigma = trace.norm(), .lookAlikes = {}, .nearest = trace.norm()};
  for (const Component& other : effectsBeyond(*model, leftover, {held}, {})) {
    const LookAlike like = compared(trace, other);
    visibility.nearest = std::min(visibility.nearest, like.difference);
    if (like.difference <= clearlyDifferent) visibility.lookAlikes.push_back(like);
  }
  std::ranges::sort(visibility.lookAlikes, {}, &LookAlike::difference);
  return visibility;
}

}  // namespace alidade
