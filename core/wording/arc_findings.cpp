#include "core/wording/findings.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace arc_finding;

namespace {

/// "(reduced χ² 53.29 with 31 degrees of freedom)".
std::string scatterText(double reducedChiSquare, double degreesOfFreedom) {
  return Phrase::of("(reduced χ² %1 with %2 degrees of freedom)", displayText(reducedChiSquare, 2),
                    displayCount(degreesOfFreedom));
}

Words wordsOf(const NotConverged& finding) {
  return {Phrase::of("the fit did not converge within %1 iterations; its result is unreliable.",
                     finding.iterations),
          Phrase::of("Check the readings for gross errors.")};
}

Words wordsOf(const NothingChecks&) {
  return {Phrase::of("the readings only just determine the circle; nothing checks them, and the uncertainty "
                     "depends on the stated noise alone."),
          Phrase::of("Sight more places.")};
}

Words wordsOf(const ScattersMore& finding) {
  return {
      Phrase::of("the readings scatter %1 times their stated noise %2.",
                 displayText(std::sqrt(finding.reducedChiSquare), 1),
                 scatterText(finding.reducedChiSquare, finding.degreesOfFreedom)),
      Phrase::of("Look for misread values or an effect missing from the model; U is scaled by the scatter.")};
}

Words wordsOf(const ScattersLess& finding) {
  return {Phrase::of("the readings agree far better than their stated noise %1.",
                     scatterText(finding.reducedChiSquare, finding.degreesOfFreedom)),
          Phrase::of("Check the stated σ, and that the readings were not copied from one another.")};
}

Words wordsOf(const RadiusPoorlyKnown& finding) {
  return {Phrase::of("an arc of %1° determines the radius only to u = %2 mm, and the centre hardly better.",
                     displayText(finding.span.degrees(), 1), displayText(finding.sigma, 1)),
          Phrase::of("Sight places over a longer arc.")};
}

Words wordsOf(const RadiusFarFromNominal& finding) {
  return {Phrase::of("the fitted radius %1 mm is far from the nominal %2 mm.", displayText(finding.fitted, 1),
                     displayText(finding.nominal, 1)),
          Phrase::of(
              "Check the distance L and the nominal radius R0: the fitted lengths are proportional to L.")};
}

Words wordsOf(const ReadingsRepeat& finding) {
  constexpr std::size_t named = 3;
  std::string rows;
  for (std::size_t i = 0; i < std::min(named, finding.rows.size()); ++i)
    rows += (rows.empty() ? "" : Phrase::of(", ")) +
            Phrase::of("%1 and %2", finding.rows[i].first + 1, finding.rows[i].second + 1);
  if (finding.rows.size() > named) rows += ", …";
  return {Phrase::of("the same pair of readings occurs twice, in rows %1.", rows),
          Phrase::of("If a row was entered twice, exclude one: a copy makes U too small.")};
}

}  // namespace

Words wordsOf(const ArcFinding& finding) {
  Words words = std::visit([](const auto& kind) { return wordsOf(kind); }, finding.what);
  words.text = Phrase::of("%1: %2", positionName(finding.axisDeg, finding.repeat), words.text);
  return words;
}

}  // namespace alidade
