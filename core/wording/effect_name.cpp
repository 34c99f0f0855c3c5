#include "core/wording/effect_name.h"

#include <algorithm>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/effects/cause_ids.h"
#include "core/session/own_effects.h"

namespace alidade {

std::string effectName(const std::string& id) {
  if (const Effect* effect = effectById(id)) return Phrase::of(effect->name);
  std::string name = visibleText(id.starts_with(ownPrefix) ? id.substr(ownPrefix.size()) : id);
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string causeName(const std::string& id) {
  if (id == jumpId) return Phrase::of("a jump of the orientation");
  if (id == grossErrorId) return Phrase::of("misread values");
  if (id == noiseId) return Phrase::of("noise larger than stated");
  if (id == formId) return Phrase::of("the form");
  if (id == relationId) return Phrase::of("the vertical angle relation");
  return effectName(id);
}

std::string causeTitle(const std::string& id) {
  std::string name = causeName(id);
  for (const std::string_view article : {"a ", "the "})
    if (name.starts_with(article)) name.erase(0, article.size());
  return withCapital(name);
}

std::string causeNames(const std::vector<std::string>& ids, const std::string& last) {
  std::vector<std::string> names;
  for (const std::string& id : ids) names.push_back(causeName(id));
  return listed(names, last);
}

std::string withCapital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string signOf(const std::string& unit) {
  if (unit == "arcsec") return "″";
  if (unit == "deg") return "°";
  return unit == "mm" ? " mm" : "";
}

std::string plausibleSizeText(const std::string& id) {
  const Effect* effect = effectById(id);
  if (!effect) return "";
  const EffectParameter& parameter = effect->parameters.front();
  return displayShortest(parameter.plausible) + signOf(std::string(parameter.unit));
}

bool isNamedBy(const std::string& effect, const std::string& parameter) {
  return effect.ends_with(parameter);
}

}  // namespace alidade
