#include "core/wording/arc_findings.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantity_text.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace arc_finding;

namespace {

/// χ² as evidence.
std::string scatterText(double reducedChiSquare, int degreesOfFreedom) {
  return "(reduced χ² " + displayText(reducedChiSquare, 2) + " with " + std::to_string(degreesOfFreedom) +
         " degrees of freedom)";
}

Words wordsOf(const NotSettled& finding) {
  return {"the fit did not settle within " + std::to_string(finding.iterations) +
              " iterations; its result is provisional.",
          "Check the readings for large errors."};
}

Words wordsOf(const NothingChecks&) {
  return {
      "the readings just fix the circle; nothing checks them, and the uncertainty rests on the stated "
      "noise alone.",
      "Sight more places."};
}

Words wordsOf(const ScattersMore& finding) {
  return {"the readings scatter " + displayText(std::sqrt(finding.reducedChiSquare), 1) +
              " times their stated noise " + scatterText(finding.reducedChiSquare, finding.degreesOfFreedom) +
              ".",
          "Look for misread values or an effect that the model does not hold; U is scaled by the scatter."};
}

Words wordsOf(const ScattersLess& finding) {
  return {"the readings agree far better than their stated noise " +
              scatterText(finding.reducedChiSquare, finding.degreesOfFreedom) + ".",
          "Check the stated σ, and that the readings were not copied from one another."};
}

Words wordsOf(const RadiusPoorlyKnown& finding) {
  return {"an arc of " + displayText(finding.span.degrees(), 1) + "° fixes the radius only to u = " +
              displayText(finding.sigma, 1) + " mm, and the centre hardly better.",
          "Sight places over a longer arc."};
}

Words wordsOf(const RadiusFarFromNominal& finding) {
  return {"the fitted radius " + displayText(finding.fitted, 1) + " mm is far from the nominal " +
              displayText(finding.nominal, 1) + " mm.",
          "Check the distance L and the nominal radius R0: the fitted lengths are proportional to L."};
}

Words wordsOf(const ReadingsRepeat& finding) {
  constexpr std::size_t named = 3;
  std::string rows;
  for (std::size_t i = 0; i < std::min(named, finding.rows.size()); ++i)
    rows += (rows.empty() ? "" : ", ") + std::to_string(finding.rows[i].first + 1) + " and " +
            std::to_string(finding.rows[i].second + 1);
  if (finding.rows.size() > named) rows += ", …";
  return {"the same pair of readings stands twice, in rows " + rows + ".",
          "If a row was entered twice, exclude one: a copy makes the result look surer than it is."};
}

}  // namespace

Words wordsOf(const ArcFinding& finding) {
  Words words = std::visit([](const auto& kind) { return wordsOf(kind); }, finding.what);
  words.text = positionName(finding.axisDeg, finding.time) + ": " + words.text;
  return words;
}

}  // namespace alidade
