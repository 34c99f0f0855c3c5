#include "core/wording/setup_findings.h"

#include "core/base/number_text.h"
#include "core/base/quantity_text.h"
#include "core/wording/position_name.h"

namespace alidade {

using namespace setup_finding;

namespace {

std::string sideOf(int axisDeg) {
  return "at " + std::to_string(axisDeg) + "° " + (axisDeg == 0 ? "below" : "above");
}

}  // namespace

std::string tooShortText(double distance) {
  return " theodolite sights anything at a distance of " + shortestText(distance) + " mm";
}

std::string lengthsToCheck(double distance, double nominalRadius) {
  return "the distance L (geometry.distance_mm: " + shortestText(distance) +
         ") and the nominal radius R0 (geometry.radius_mm: " + shortestText(nominalRadius) + "), both in mm";
}

Words wordsOf(const DistanceTooShort& finding) {
  return {"No" + tooShortText(finding.distance) + ".",
          "Check " + lengthsToCheck(finding.distance, finding.nominalRadius) +
              ": the fitted lengths are proportional to the distance."};
}

Words wordsOf(const PlacesOnTheWrongSide& finding) {
  const bool several = finding.axesDeg.size() > 1;
  return {"Most places lie " + sideOf(finding.axesDeg.front()) +
              (several ? " and " + sideOf(finding.axesDeg.back()) : "") +
              " the fitted centre, where an arc at 0° has them above and one at 180° below: Δd may have the "
              "wrong sign.",
          several ? "Check the kind of the vertical circle, and whether the positions are exchanged."
                  : "Check the axis of this position, its pointing zero and its readings."};
}

Words wordsOf(const ZeroOfOtherCircle& finding) {
  const bool zenith = finding.circle == VerticalCircle::Zenith;
  const std::string own =
      zenith ? "a zenith circle, which reads 90° there" : "an elevation circle, which reads 0° there";
  return {"The pointing zero at " + positionName(finding.axisDeg, finding.time) + " has " +
              displayText(finding.vertical.degrees(), 2) +
              "° on the vertical circle, far from the horizon of " + own + ".",
          std::string("Check the kind of the vertical circle: as ") + (zenith ? "an elevation" : "a zenith") +
              " circle its readings grow the other way, which turns the sign of Δd."};
}

Words wordsOf(const SlidersDiffer& finding) {
  return {positionName(finding.axisDeg, finding.time) + ": rows " + std::to_string(finding.firstRow + 1) +
              " and " + std::to_string(finding.otherRow + 1) +
              " are of one visit, yet their slider values differ by " +
              displayText(finding.apart.arcseconds(), 1) + "″; the first alone is used" +
              (finding.others > 0 ? ", here and in " + std::to_string(finding.others) + " more" : "") + ".",
          "The slider stands still during a visit: correct the value, or give the rows different points or "
          "rounds."};
}

Words wordsOf(const ZerosAlike& finding) {
  const std::string all = finding.positions > 2 ? "All positions" : "Both positions";
  return {
      all +
          " have the same pointing zero: sighted once it is wrong by the same everywhere, which cancels in "
          "Δd, sighted in each it would hardly be read alike.",
      "State geometry.pointing_zeros: one, if it was sighted once, or each."};
}

Words wordsOf(const ZeroMoved& finding) {
  const auto moved = [](Angle move, Angle sigma) {
    return displayText(move.arcseconds(), 1) + "″ ± " + displayText(sigma.arcseconds(), 1) + "″";
  };
  return {positionName(finding.axisDeg, finding.time) + ": the pointing zero moved by " +
              moved(finding.horizontal, finding.sigmaHorizontal) + " horizontally and " +
              moved(finding.vertical, finding.sigmaVertical) +
              " vertically (1σ) while the position was read" +
              (finding.scatter > 1
                   ? "; U takes the zeros to scatter " + displayText(finding.scatter, 1) + " times as stated"
                   : "") +
              ".",
          "Look for a knock of the tripod or an orientation that drifts, and observe the position again."};
}

Words wordsOf(const ZeroFaceLeftOut& finding) {
  return {
      positionName(finding.axisDeg, finding.time) +
          ": the sightings of the pointing zero in face 2 are left out, since not every position has one: "
          "collimation and index would not cancel.",
      "Sight the zeros of all positions in both faces."};
}

}  // namespace alidade
