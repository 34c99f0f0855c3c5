#include "core/diagnosis/search/explained_model.h"

#include <cmath>
#include <cstddef>

namespace alidade {

GapModel modelWith(const GapModel& base, const Explanation& explanation,
                   const std::vector<Component>& candidates, const Leftover& leftover) {
  GapModel model{base.measurement, base.starts, base.options, {}, base.noise};
  for (const Part& part : explanation.parts) {
    if (part.component >= candidates.size()) {
      model.options.without.push_back(
          readingRef(leftover, static_cast<Eigen::Index>(part.component - candidates.size())));
      continue;
    }
    const Component& component = candidates[part.component];
    const double width = part.widthOfFit();
    if (component.kind == Component::Kind::Jump) {
      const double sigma = width * plausibleJump;
      model.options.jumpBefore = component.moment;
      model.options.terms.push_back({ErrorTerm::HorizontalJump, sigma});
      model.options.terms.push_back({ErrorTerm::VerticalJump, sigma});
    } else if (component.allOrNothing) {
      constexpr double whole = 1, exactly = 1e-6;
      model.options.terms.push_back({component.effect->parameters[0].term, exactly, whole, whole});
    } else if (component.kind == Component::Kind::Effect) {
      for (std::size_t p = 0; p < component.effect->parameters.size(); ++p) {
        const EffectParameter& parameter = component.effect->parameters[p];
        const double unit = plausibleSize(parameter);
        model.options.terms.push_back(
            {parameter.term, width * unit, 0, part.weights[static_cast<Eigen::Index>(p)] * unit});
      }
    }
  }
  model.fit = fitJointly(*model.measurement, model.starts, model.options);
  if (explanation.noisy && model.fit.isDetermined() && model.fit.degreesOfFreedom > 0)
    model.noise = std::sqrt(model.fit.chiSquare / model.fit.degreesOfFreedom);
  return model;
}

}  // namespace alidade
