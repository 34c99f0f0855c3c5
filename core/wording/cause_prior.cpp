#include "core/wording/cause_prior.h"

#include "core/base/number_text.h"
#include "core/effects/catalogue.h"

namespace alidade {

std::string plausibleSizeText(const std::string& id) {
  const Effect* effect = effectById(id);
  if (!effect) return "";
  const EffectParameter& parameter = effect->parameters.front();
  return shortestText(parameter.plausible) +
         (parameter.unit.size() > 1 ? " " + std::string(parameter.unit) : "");
}

}  // namespace alidade
