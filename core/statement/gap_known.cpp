#include <algorithm>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/known_sizes.h"
#include "core/statement/gap.h"
#include "core/wording/effect_name.h"
#include "core/wording/size_text.h"

namespace alidade {

namespace {

std::string nameOf(const Effect& effect, const EffectParameter& number) {
  std::string name = causeTitle(std::string(effect.id));
  if (effect.parameters.size() < 2) return name;
  //: an effect and which of its numbers: "plane tilt, tilt about x"
  return Phrase::of("%1, %2", name, parameterName(number.name));
}

/// The source and date of a known size; only the source if it names the date, as sources often do.
std::string sourceText(const KnownPrior& known) {
  if (known.from.empty() && known.date.empty()) return "—";
  if (known.from.empty() || known.date.empty() || known.from.find(known.date) != std::string::npos)
    return visibleText(known.from.empty() ? known.date : known.from);
  return listed({visibleText(known.from), visibleText(known.date)});
}

/// The comparison of a known number with the readings; null without a comparison.
const KnownCheck* checkOf(const Gap& gap, const Effect& effect, const EffectParameter& number) {
  if (!gap.diagnosis) return nullptr;
  const auto found = std::ranges::find_if(gap.diagnosis->known, [&](const KnownCheck& check) {
    return check.effect == effect.id && check.name == number.name;
  });
  return found == gap.diagnosis->known.end() ? nullptr : &*found;
}

}  // namespace

Statement gapKnown(const Gap& gap) {
  Statement statement{.id = "known",
                      .title = Phrase::of("Known sizes of instrument and device"),
                      .columns = {{"number", Phrase::of("Known size"), Statement::Column::Role::Name},
                                  {"known", Phrase::of("known")},
                                  {"readings", Phrase::of("these readings")},
                                  {"from", Phrase::of("known from"), Statement::Column::Role::Text}},
                      .rows = {}};
  const auto& measurement = gap.evaluation->examined.measurement;
  if (!measurement || !isAnythingKnown(*measurement)) return statement;
  for (const Effect& effect : effectCatalogue())
    for (const EffectParameter& number : effect.parameters) {
      const auto known = knownOf(*measurement, number);
      if (!known) continue;
      const double unit = modelUnitsPer(number.unit);
      const KnownCheck* check = checkOf(gap, effect, number);
      statement.rows.push_back(
          {.cells = {nameOf(effect, number),
                     sizeWithStandard(known->value / unit, known->sigma / unit, std::string(number.unit)),
                     check && check->isSeen ? sizeWithStandard(check->value, check->sigma, check->unit) : "—",
                     sourceText(*known)},
           .id = std::string(effect.id)});
    }
  statement.note = Phrase::of(
      "Each value enters the uncertainty and the search for causes with its u; the prior probability that it "
      "is out of date is one in fifty. A dash: these readings are too weak to check it.");
  return statement;
}

}  // namespace alidade
