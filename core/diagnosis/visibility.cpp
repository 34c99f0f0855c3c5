#include "core/diagnosis/visibility.h"

#include <algorithm>

#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/inquiry.h"
#include "core/effects/cause_ids.h"

namespace alidade {

Visibility visibilityIn(const GapModel& model, const std::string& held) {
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
  const Trace trace(leftover, leftover.residual());
  Visibility visibility{.sigma = trace.length(), .lookAlikes = {}, .nearest = trace.length()};
  const auto compare = [&](const Component& other) {
    const LookAlike like = trace.compared(other);
    visibility.nearest = std::min(visibility.nearest, like.difference);
    if (like.difference > thresholds.clearlyDifferent) return;
    const auto same = std::ranges::find(visibility.lookAlikes, like.effect, &LookAlike::effect);
    if (same == visibility.lookAlikes.end())
      visibility.lookAlikes.push_back(like);
    else if (like.difference < same->difference)
      *same = like;
  };
  for (const Component& other : effectsBeyond(model, leftover, {held})) compare(other);
  if (held != jumpId)
    for (const Component& other : wrongZeros(leftover)) compare(other);
  std::ranges::sort(visibility.lookAlikes, {}, &LookAlike::difference);
  return visibility;
}

Result<Visibility, NoModel> visibilityOf(const Measurement& noiseless, const std::string& held) {
  const auto own = modelOf(noiseless);
  if (!own) return own.problem();
  return visibilityIn(closedModelOf(*own).value_or(*own), held);
}

}  // namespace alidade
