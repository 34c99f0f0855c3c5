#include "core/wording/findings.h"

#include <string>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace session_finding;

namespace {

std::string threeDecimals(double millimetres) {
  return displayText(millimetres, 3);
}

}  // namespace

Words wordsOf(const ArcMissing& finding) {
  return {
      Phrase::of("The arc at %1 %2.", positionName(finding.axisDeg, finding.repeat), textOf(finding.why))};
}

Words wordsOf(const Undetermined& finding) {
  if (finding.hasEffects)
    return {
        Phrase::of("The readings of all positions do not determine the circles and the effects of the model "
                   "together."),
        Phrase::of("Look for misread values, sight more places over a longer arc, or take effects out of the "
                   "model.")};
  return {Phrase::of("The readings of all positions do not determine the circles together."),
          Phrase::of("Look for misread values, or sight more places over a longer arc.")};
}

Words wordsOf(const PositionMissing& finding) {
  return {Phrase::of("There is no usable position at %1°, so the intersection cannot be computed.",
                     finding.axisDeg),
          Phrase::of("The intersection is half the distance of the arc centres at 0° and 180°: measure both "
                     "positions.")};
}

Words wordsOf(const RadiiDiffer& finding) {
  return {Phrase::of(
              "The radii of the one rigid arc at 0° and 180° differ by %1 mm, more than their noise allows "
              "(%2 mm at 0.1 % risk).",
              threeDecimals(finding.difference), threeDecimals(finding.bound)),
          Phrase::of("Look for a cause outside the model, such as a plane off the axis.")};
}

Words wordsOf(const CentresDiffer& finding) {
  return {Phrase::of(
              "Along the axis the centres at 0° and 180° differ by %1 mm, more than readings and zeros allow "
              "(%2 mm at 0.1 % risk).",
              threeDecimals(finding.difference), threeDecimals(finding.bound)),
          Phrase::of("Look for a knock or a drift since the pointing zero, or for play along the axis.")};
}

Words wordsOf(const KnownRadiusContradicted& finding) {
  return {Phrase::of("The readings disagree with the known radius of %1 mm: they shift it by %2 mm; the "
                     "noise of the readings and the σ of the radius allow at most %3 mm at 0.1 % risk.",
                     displayShortest(finding.nominal), displayText(finding.pulledBy, 4),
                     displayText(finding.bound, 4)),
          Phrase::of("Check R0, its σ and the distance, or let the radius be free.")};
}

Words wordsOf(const NominalRadiusContradicted& finding) {
  return {Phrase::of(
              "The fitted radius differs from the nominal radius of %1 mm by %2 mm; the readings and the σ "
              "of R0 and L allow at most %3 mm at 0.1 % risk.",
              displayShortest(finding.nominal), displayText(finding.away, 3), displayText(finding.bound, 3)),
          Phrase::of("Check R0, its σ and the distance: the diagnosis seeks causes of this difference.")};
}

Words wordsOf(const PositionCopied& finding) {
  return {
      Phrase::of(
          "%1 has the same readings as %2: a copy counts as a measurement of its own, and makes U too small.",
          positionName(finding.axisDeg, finding.repeat), positionName(finding.axisDeg, finding.earlier)),
      Phrase::of("Delete the copied position, or type the readings taken there.")};
}

Words wordsOf(const UnknownEffect& finding) {
  return {Phrase::of("The session's model names %1, which is no effect that can be estimated.",
                     quotation(finding.id)),
          Phrase::of("The result is computed without it: correct the name.")};
}

Words wordsOf(const KnownOfNothing& finding) {
  const std::string effect = quotation(finding.effect), unit = quotation(finding.unit);
  return {finding.parameter.empty()
              ? Phrase::of("The known size of %1 in %2 matches no entry of the catalogue.", effect, unit)
              : Phrase::of("The known size of %1 (%2) in %3 matches no entry of the catalogue.", effect,
                           quotation(finding.parameter), unit),
          Phrase::of("Name the effect, its parameter (if it has two) and the unit as in the catalogue; until "
                     "then its plausible size is used.")};
}

Words wordsOf(const CorrectionsDiffer& finding) {
  return {Phrase::of(
              //: %1: words of the session file, such as "inclination, collimation"
              "The rows differ in what the instrument corrected by itself (%1), so none of these corrections "
              "is used as known.",
              listed(finding.switches)),
          Phrase::of("Measure with the same corrections throughout, and state them with every reading.")};
}

Words wordsOf(const TiltsUnused&) {
  return {Phrase::of("The compensator's tilts are not used: the readings do not state whether the instrument "
                     "has already corrected for them."),
          Phrase::of("For every reading, state which corrections were on; type “none” if all were off.")};
}

Words wordsOf(const AxisMoved& finding) {
  return {
      Phrase::of("According to the compensator, the vertical axis moved by %1″ from one position to another.",
                 displayText(finding.change.arcseconds(), 1)),
      Phrase::of("Check the tripod; the uncertainty of the known tilt includes half of this movement.")};
}

Words wordsOf(const CompensatorOff& finding) {
  return {
      Phrase::of("The compensator's tilts in the two faces contradict each other by %1″; they are not used.",
                 displayText(finding.index.arcseconds(), 1)),
      Phrase::of("Calibrate the compensator's index. In face 2, tilts refer to the instrument's axes, which "
                 "are turned by 180°.")};
}

Words wordsOf(const PlanarRelation&) {
  return {
      Phrase::of("The model assumes that the vertical circle reads y/L, which no theodolite does."),
      Phrase::of("Set the relation of the vertical angle to “exact”, unless you study the planar relation.")};
}

}  // namespace alidade
