#include "core/wording/session_findings.h"

#include <string>

#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/wording/arc_fault.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace session_finding;

namespace {

/// "1.959 mm, more than their noise allows (0.544 mm at 0.1 % risk)".
std::string beyondChance(double difference, const std::string& by, double bound) {
  return displayText(difference, 3) + " mm, more than " + by + " (" + displayText(bound, 3) +
         " mm at 0.1 % risk).";
}

}  // namespace

Words wordsOf(const ArcMissing& finding) {
  return {"The arc at " + positionName(finding.axisDeg, finding.time) + " " + textOf(finding.why) + "."};
}

Words wordsOf(const Undetermined& finding) {
  return {std::string("The readings of all positions do not determine the circles") +
              (finding.hasEffects ? " and the effects of the model together" : " together") + ".",
          std::string("Look for misread values, sight more places over a longer arc") +
              (finding.hasEffects ? ", or take effects out of the model." : ".")};
}

Words wordsOf(const PositionMissing& finding) {
  return {"There is no usable position at " + std::to_string(finding.axisDeg) + "°, so no intersection.",
          "The intersection is half the distance of the arc centres at 0° and 180°: measure both."};
}

Words wordsOf(const RadiiDiffer& finding) {
  return {"The radii of the one rigid arc at 0° and 180° differ by " +
              beyondChance(finding.difference, "their noise allows", finding.bound),
          "Look for a cause outside the model, such as a plane off the axis."};
}

Words wordsOf(const CentresDiffer& finding) {
  return {"Along the axis the centres at 0° and 180° differ by " +
              beyondChance(finding.difference, "readings and zeros allow", finding.bound),
          "Look for a knock or a drift since a zero, or play along the axis."};
}

Words wordsOf(const KnownRadiusContradicted& finding) {
  return {"The readings do not agree with the known radius of " + displayShortest(finding.nominal) +
              " mm: they pull it by " + displayText(finding.pulledBy, 4) + " mm, where " +
              displayText(finding.bound, 4) +
              " mm is the most that their noise and its σ allow at 0.1 % risk.",
          "Check R0, its σ and the distance, or let the radius be free."};
}

Words wordsOf(const OffReference& finding) {
  return {"By the fit alone the intersection differs from the reference " +
              displayShortest(finding.reference) + " mm by " + displayText(finding.difference, 3) +
              " mm, more than its expanded uncertainty of " + displayText(finding.expanded, 3) + " mm.",
          "Nothing was fitted to the reference; find what separates the two."};
}

Words wordsOf(const UnknownEffect& finding) {
  return {
      "The session's model names " + quotation(finding.id) + ", which is no effect that can be estimated.",
      "Read the result as one without it, or correct the name."};
}

Words wordsOf(const KnownOfNothing& finding) {
  const std::string which = finding.parameter.empty() ? "" : ", " + quotation(finding.parameter) + ",";
  return {
      "What is known of " + quotation(finding.effect) + which + " in " + quotation(finding.unit) +
          " is of no number of the catalogue.",
      "Name an effect, which of its numbers where it has two, and the unit as the catalogue has them; until "
      "then its plausible size is taken."};
}

Words wordsOf(const PlanarRelation&) {
  return {"The model takes the vertical circle to read y/L, which no theodolite does.",
          "Set the vertical angle to exact, unless the planar relation is to be studied."};
}

}  // namespace alidade
