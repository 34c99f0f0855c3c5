#include "core/wording/diagnosis_sentence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/wording/effect_name.h"
#include "core/wording/findings.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

/// "3.20 ± 0.50″".
std::string sizeText(double value, double sigma, const std::string& unit) {
  const int decimals = decimalsFor(sigma, 0);
  const std::string numbers =
      Phrase::of("%1 ± %2", displayText(value, decimals), displayText(sigma, decimals));
  if (unit == "arcsec") return numbers + "″";
  if (unit == "deg") return numbers + "°";
  return unit.size() < 2 ? numbers : numbers + ' ' + unit;
}

std::string numberText(const KnownCheck& check) {
  const Effect* effect = effectById(check.effect);
  if (!effect || effect->parameters.size() < 2) return causeName(check.effect);
  //: an effect and which of its numbers: "plane tilt, tilt about x"
  return Phrase::of("%1, %2", causeName(check.effect), parameterName(check.name));
}

std::string sourceText(const KnownCheck& check) {
  return check.from.empty() ? Phrase::of("what is known beforehand") : visibleText(check.from);
}

std::string staleText(const KnownCheck& check, const std::string& probability) {
  return Phrase::of(
      //: where it is known from, effect, size known, size by the readings, probability: "more than 99.9 %"
      "According to %1, %2 is %3; these readings give %4: the known size is out of date with a probability "
      "of %5.",
      sourceText(check), numberText(check), sizeText(check.known, check.sigmaKnown, check.unit),
      sizeText(check.value, check.sigma, check.unit), probability);
}

/// Whether the tilt from the readings has the opposite sign of the known tilt. Each number is tested
/// separately, because the compensator has two axes.
bool isOtherWayRound(const Diagnosis& diagnosis, const std::string& effect) {
  constexpr double apart = 4, alike = 2;  // in σ
  return effect == "vertical_axis_tilt" && std::ranges::any_of(diagnosis.known, [&](const KnownCheck& check) {
           const double sigma = std::hypot(check.sigma, check.sigmaKnown);
           return check.effect == effect && check.isSeen &&
                  std::abs(check.value - check.known) > apart * sigma &&
                  std::abs(check.value + check.known) < alike * sigma;
         });
}

bool isKnown(const Diagnosis& diagnosis, const std::string& effect) {
  return std::ranges::find(diagnosis.known, effect, &KnownCheck::effect) != diagnosis.known.end();
}

/// Returns the number of an effect that deviates most, in σ, from its known value. Null if the readings
/// determine none of its numbers.
const KnownCheck* farthest(const Diagnosis& diagnosis, const std::string& effect) {
  const auto sigmas = [](const KnownCheck& check) {
    return std::abs(check.value - check.known) / std::hypot(check.sigma, check.sigmaKnown);
  };
  const KnownCheck* found = nullptr;
  for (const KnownCheck& check : diagnosis.known)
    if (check.effect == effect && check.isSeen && (!found || sigmas(check) > sigmas(*found))) found = &check;
  return found;
}

}  // namespace

std::string staleSentence(const Diagnosis& diagnosis) {
  std::string sentences;
  const auto add = [&](const std::string& sentence) { sentences = inTurn(sentences, sentence); };
  for (const Cause& cause : diagnosis.causes) {
    if (const KnownCheck* check = cause.isStale ? farthest(diagnosis, cause.effect) : nullptr)
      add(staleText(*check, probabilityText(cause.probability)));
    if (cause.isStale && isOtherWayRound(diagnosis, cause.effect))
      add(
          Phrase::of("With the opposite sign, the tilts would agree with the readings: look up the sign "
                     "convention of the instrument's tilts."));
    std::vector<std::string> others;
    for (const auto& ids : {cause.unlessStale, cause.indistinguishableFrom})
      for (const std::string& id : ids)
        if (isKnown(diagnosis, id) && !cause.isStale) others.push_back(causeName(id));
    if (others.empty()) continue;
    add(Phrase::of(
        //: causes, and a cause: these readings show them alike
        "If the known size of %1 were out of date, these readings could not distinguish this from %2.",
        listed(others, Phrase::of(" or ")), causeName(cause.effect)));
  }
  return sentences;
}

}  // namespace alidade
