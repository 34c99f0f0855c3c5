#include "core/wording/effect_name.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/session/own_effects.h"

namespace alidade {

std::string effectName(const std::string& id) {
  if (const Effect* effect = effectById(id)) return Phrase::of(effect->name);
  std::string name = visibleText(id.starts_with(ownPrefix) ? id.substr(ownPrefix.size()) : id);
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string signOf(const std::string& unit) {
  if (unit == "arcsec") return "″";
  if (unit == "deg") return "°";
  return unit == "mm" ? " mm" : "";
}

}  // namespace alidade
