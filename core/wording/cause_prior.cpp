#include "core/wording/cause_prior.h"

#include "core/base/quantity_text.h"
#include "core/effects/catalogue.h"
#include "core/wording/effect_name.h"

namespace alidade {

std::string plausibleSizeText(const std::string& id) {
  const Effect* effect = effectById(id);
  if (!effect) return "";
  const EffectParameter& parameter = effect->parameters.front();
  return displayShortest(parameter.plausible) + signOf(std::string(parameter.unit));
}

}  // namespace alidade
