#include "core/wording/findings.h"

#include "core/adjustment/result/reading_step.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace setup_finding;

namespace {

std::string sideOf(int axisDeg) {
  return axisDeg == 0 ? Phrase::of("at 0° below it") : Phrase::of("at %1° above it", axisDeg);
}

}  // namespace

std::string lengthsToCheck(double distance, double nominalRadius) {
  return Phrase::of("the distance L (%1) and the nominal radius R0 (%2), both in mm", shortestText(distance),
                    shortestText(nominalRadius));
}

Words wordsOf(const DistanceTooShort& finding) {
  return {Phrase::of("No theodolite sights anything at a distance of %1 mm.", shortestText(finding.distance)),
          Phrase::of("Check %1: the fitted lengths are proportional to the distance.",
                     lengthsToCheck(finding.distance, finding.nominalRadius))};
}

Words wordsOf(const PlacesOnTheWrongSide& finding) {
  const bool several = finding.axesDeg.size() > 1;
  const std::string front = sideOf(finding.axesDeg.front());
  return {Phrase::of("Most places lie on the wrong side of the fitted centre, %1: they should be above it at "
                     "0° and below it at 180°. Δd may have the wrong sign.",
                     several ? Phrase::of("%1 and %2", front, sideOf(finding.axesDeg.back())) : front),
          several
              ? Phrase::of("Check the kind of the vertical circle, and whether the positions are exchanged.")
              : Phrase::of("Check the axis of this position, its pointing zero and its readings.")};
}

Words wordsOf(const ZeroOfOtherCircle& finding) {
  const bool zenith = finding.circle == VerticalCircle::Zenith;
  const std::string where = positionName(finding.axisDeg, finding.repeat),
                    reading = displayText(finding.vertical.degrees(), 2);
  if (zenith)
    return {
        Phrase::of("The pointing zero at %1 has %2° on the vertical circle, far from the horizon of a zenith "
                   "circle, which reads 90° there.",
                   where, reading),
        Phrase::of("Check the kind of the vertical circle: on an elevation circle its readings grow the "
                   "other way, and Δd changes its sign.")};
  return {Phrase::of(
              "The pointing zero at %1 has %2° on the vertical circle, far from the horizon of an elevation "
              "circle, which reads 0° there.",
              where, reading),
          Phrase::of("Check the kind of the vertical circle: on a zenith circle its readings grow the other "
                     "way, and Δd changes its sign.")};
}

Words wordsOf(const SlidersDiffer& finding) {
  const std::string where = positionName(finding.axisDeg, finding.repeat),
                    apart = displayText(finding.apart.arcseconds(), 1);
  const std::size_t first = finding.firstRow + 1, other = finding.otherRow + 1;
  return {
      finding.others > 0 ? Phrase::of("%1: rows %2 and %3 are of one visit, yet their slider values differ "
                                      "by %4″; only the first is used, here and in %5 more cases.",
                                      where, first, other, apart, finding.others)
                         : Phrase::of("%1: rows %2 and %3 are of one visit, yet their slider values differ "
                                      "by %4″; only the first is used.",
                                      where, first, other, apart),
      Phrase::of(
          "The slider stands still during a visit: correct the value, or give the rows different points or "
          "rounds.")};
}

Words wordsOf(const ZerosAlike& finding) {
  return {finding.positions > 2
              ? Phrase::of("All positions have the same pointing zero. If it was sighted once, its error "
                           "cancels in Δd; if it was sighted in each position, equal readings are unlikely.")
              : Phrase::of("Both positions have the same pointing zero. If it was sighted once, its error "
                           "cancels in Δd; if it was sighted in each position, equal readings are unlikely."),
          Phrase::of("State under “Pointing zeros” which of the two is true.")};
}

Words wordsOf(const ZerosDiffer& finding) {
  const auto arcseconds = [](Angle angle) { return displayText(angle.arcseconds(), 1) + "″"; };
  return {
      Phrase::of("The pointing zeros differ by %1 horizontally and %2 vertically, more than two sightings of "
                 "one mark would.",
                 arcseconds(finding.horizontal), arcseconds(finding.vertical)),
      Phrase::of("State under “Zeros sight” the target of the zeros: a mark; the guideway's own normal, set "
                 "again in each position; or unknown.")};
}

Words wordsOf(const ReadingsRounded& finding) {
  const std::string step = displayShortest(finding.step.arcseconds()) + "″",
                    rounding = displayText(roundingSigma(finding.step).arcseconds(), 1) + "″",
                    stated = displayShortest(finding.sigma.arcseconds()) + "″";
  return {
      finding.isVertical
          ? Phrase::of(
                "All readings of the vertical circle are multiples of %1: rounding alone scatters them "
                "by %2 (1σ), more than the stated %3.",
                step, rounding, stated)
          : Phrase::of(
                "All readings of the horizontal circle are multiples of %1: rounding alone scatters them "
                "by %2 (1σ), more than the stated %3.",
                step, rounding, stated),
      Phrase::of("Enter the readings as finely as the instrument gives them, or state a σ of at least %1.",
                 rounding)};
}

Words wordsOf(const ZeroMoved& finding) {
  const auto moved = [](Angle move, Angle sigma) {
    return displayText(move.arcseconds(), 1) + "″ ± " + displayText(sigma.arcseconds(), 1) + "″";
  };
  const std::string where = positionName(finding.axisDeg, finding.repeat),
                    horizontal = moved(finding.horizontal, finding.sigmaHorizontal),
                    vertical = moved(finding.vertical, finding.sigmaVertical);
  if (finding.isOfOneFace)
    return {
        Phrase::of("%1: while the position was read, the pointing zero changed in face 2 by %2 horizontally "
                   "and %3 vertically more than in face 1 (1σ): one of these sightings may be misread; U "
                   "assumes that the zeros scatter %4 times their stated σ.",
                   where, horizontal, vertical, displayText(finding.scatter, 1)),
        Phrase::of("Check the entries of the pointing zero, or sight it again in both faces.")};
  return {
      finding.scatter > 1
          ? Phrase::of("%1: the pointing zero moved by %2 horizontally and %3 vertically (1σ) while the "
                       "position was read; U assumes that the zeros scatter %4 times their stated σ.",
                       where, horizontal, vertical, displayText(finding.scatter, 1))
          : Phrase::of(
                "%1: the pointing zero moved by %2 horizontally and %3 vertically (1σ) while the position "
                "was read.",
                where, horizontal, vertical),
      Phrase::of(
          "Look for a knock of the tripod or an orientation that drifts, and observe the position again.")};
}

Words wordsOf(const ZeroFaceLeftOut& finding) {
  return {
      Phrase::of(
          "%1: the sightings of the pointing zero in face 2 are left out, since not every position has one: "
          "collimation and index would not cancel.",
          positionName(finding.axisDeg, finding.repeat)),
      Phrase::of("Sight the zeros of all positions in both faces.")};
}

}  // namespace alidade
