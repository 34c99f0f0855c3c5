#include "core/diagnosis/search/explained_model.h"

#include <cmath>

namespace alidade {

GapModel modelWith(const GapModel& base, const Explanation& explanation, const Candidates& candidates,
                   const Leftover& leftover) {
  GapModel model{base.measurement, base.starts, base.options, {}, base.noise};
  for (const Part& part : explanation.parts)
    candidates[part.component].addTo(model.options, leftover, part.weights, part.widthOfFit());
  model.fit = fitJointly(*model.measurement, model.starts, model.options);
  if (explanation.noisy && model.fit.isDetermined() && model.fit.degreesOfFreedom > 0)
    model.noise = std::sqrt(model.fit.chiSquare / model.fit.degreesOfFreedom);
  return model;
}

}  // namespace alidade
