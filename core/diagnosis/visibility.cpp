#include "core/diagnosis/visibility.h"

#include <algorithm>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

Result<Visibility, NoModel> visibilityOf(const Measurement& noiseless, const std::string& held) {
  const auto model = modelOf(noiseless);
  if (!model) return model.problem();
  const Leftover leftover(linearise(*model->measurement, model->fit, model->options), model->options.terms);
  const Trace trace(leftover, leftover.residual());
  Visibility visibility{.sigma = trace.length(), .lookAlikes = {}, .nearest = trace.length()};
  for (const Component& other : effectsBeyond(*model, leftover, {held})) {
    const LookAlike like = trace.compared(other);
    visibility.nearest = std::min(visibility.nearest, like.difference);
    if (like.difference <= clearlyDifferent) visibility.lookAlikes.push_back(like);
  }
  std::ranges::sort(visibility.lookAlikes, {}, &LookAlike::difference);
  return visibility;
}

}  // namespace alidade
