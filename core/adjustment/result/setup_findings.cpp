#include "core/adjustment/result/setup_findings.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/quantity_text.h"
#include "core/observation/half_turn.h"
#include "core/observation/visits.h"

namespace alidade {

namespace {

constexpr double grosslyOff = 0.2;
constexpr double shortestFocus = 100;  // mm

std::string lengthsToCheck(const Measurement& measurement) {
  return "the distance L (geometry.distance_mm: " + shortestText(measurement.distance) +
         ") and the nominal radius R0 (geometry.radius_mm: " + shortestText(measurement.nominalRadius) +
         "), both in mm";
}

std::string tooShort(const Measurement& measurement) {
  return " theodolite sights anything at a distance of " + shortestText(measurement.distance) + " mm";
}

void judgeDistance(std::vector<Finding>& findings, const Measurement& measurement) {
  if (measurement.distance >= shortestFocus) return;
  findings.push_back(
      {Severity::Warning, "No" + tooShort(measurement) + ".",
       "Check " + lengthsToCheck(measurement) + ": the fitted lengths are proportional to the distance.",
       Place{.position = {}, .reading = {}, .field = "geometry.distance_mm"}});
}

/// Most rows lie below the centre at 0°, above it at 180°.
bool isUpsideDown(const ArcFit& arc) {
  const double up = halfTurnSign(arc.axisDeg);
  const auto wrong = std::ranges::count_if(
      arc.residuals, [&](const SightingResidual& row) { return up * std::sin(row.arcAngle) < 0; });
  return 2 * static_cast<std::size_t>(wrong) > arc.residuals.size();
}

std::string sideOf(const ArcFit& arc) {
  return "at " + std::to_string(arc.axisDeg) + "° " + (arc.axisDeg == 0 ? "below" : "above");
}

void judgeSides(std::vector<Finding>& findings, const SessionFit& fit) {
  std::vector<const ArcFit*> wrong;
  for (const ArcFit& arc : fit.arcs)
    if (isUpsideDown(arc)) wrong.push_back(&arc);
  if (wrong.empty()) return;
  std::string text = "Most places lie " + sideOf(*wrong.front());
  if (wrong.size() > 1) text += " and " + sideOf(*wrong.back());
  text +=
      " the fitted centre, where an arc at 0° has them above and one at 180° below: Δd may have the wrong "
      "sign.";
  findings.push_back({Severity::Warning, std::move(text),
                      wrong.size() > 1
                          ? "Check the kind of the vertical circle, and whether the positions are exchanged."
                          : "Check the axis of this position, its pointing zero and its readings.",
                      Place{.position = wrong.front()->position, .reading = {}, .field = "axis_deg"}});
}

/// How far a reading of the vertical circle is from the horizon, 0…90°.
double fromHorizon(Angle vertical, VerticalCircle circle) {
  const double horizon = circle == VerticalCircle::Zenith ? 90 : 0;
  return std::abs(std::remainder(vertical.degrees() - horizon, 180));
}

/// A zero nearer to the other kind's horizon than to its own.
void judgeVerticalCircle(std::vector<Finding>& findings, const Measurement& measurement) {
  constexpr double halfWay = 45;
  const bool zenith = measurement.verticalCircle == VerticalCircle::Zenith;
  for (const ArcMeasurement& arc : measurement.arcs) {
    if (fromHorizon(arc.zeroVertical, measurement.verticalCircle) <= halfWay) continue;
    const std::string own =
        zenith ? "a zenith circle, which reads 90° there" : "an elevation circle, which reads 0° there";
    findings.push_back({Severity::Warning,
                        "The pointing zero at " + std::to_string(arc.axisDeg) + "° has " +
                            displayText(arc.zeroVertical.degrees(), 2) +
                            "° on the vertical circle, far from the horizon of " + own + ".",
                        std::string("Check the kind of the vertical circle: as ") +
                            (zenith ? "an elevation" : "a zenith") +
                            " circle its readings grow the other way, which turns the sign of Δd.",
                        Place{.position = arc.position, .reading = {}, .field = "pointing_zero.vertical"}});
  }
}

/// A slider value that differs from the first of its visit.
struct OtherSlider {
  std::size_t first, other;  // rows
  Angle apart;
};

std::vector<OtherSlider> otherSliders(const ArcMeasurement& arc) {
  constexpr double rounding = 1e-6;  // arcsec: two notations of one angle
  std::vector<OtherSlider> others;
  for (const Visit& visit : visitsOf(arc)) {
    const Sighting* first = sliderOf(arc, visit);
    for (const std::size_t i : visit.sightings) {
      const Sighting& row = arc.sightings[i];
      if (!row.slider) continue;
      const Angle apart = Angle::fromArcseconds(std::abs(wrapped(*row.slider - *first->slider).arcseconds()));
      if (apart.arcseconds() > rounding) others.push_back({first->row, row.row, apart});
    }
  }
  return others;
}

void judgeSliders(std::vector<Finding>& findings, const ArcMeasurement& arc) {
  const std::vector<OtherSlider> others = otherSliders(arc);
  if (others.empty()) return;
  const OtherSlider& most = *std::ranges::max_element(others, {}, &OtherSlider::apart);
  std::string text = std::to_string(arc.axisDeg) + "°: rows " + std::to_string(most.first + 1) + " and " +
                     std::to_string(most.other + 1) +
                     " are of one visit, yet their slider values differ by " +
                     displayText(most.apart.arcseconds(), 1) + "″; the first alone is used";
  if (others.size() > 1) text += ", here and in " + std::to_string(others.size() - 1) + " more";
  findings.push_back({Severity::Warning, text + ".",
                      "The slider stands still during a visit: correct the value, or give the rows different "
                      "points or rounds.",
                      Place{.position = arc.position, .reading = most.other, .field = "slider"}});
}

}  // namespace

std::optional<std::string> doubtfulLengths(const Measurement& measurement, const std::vector<ArcFit>& arcs) {
  if (measurement.distance < shortestFocus)
    return "no" + tooShort(measurement) + ": check " + lengthsToCheck(measurement) + ".";
  for (const ArcFit& arc : arcs) {
    const double off = std::abs(arc.circle.radius - measurement.nominalRadius);
    if (off <= grosslyOff * measurement.nominalRadius + 3 * arc.radiusSigma()) continue;
    return "the radius fitted at " + std::to_string(arc.axisDeg) + "° is " +
           displayText(100 * off / measurement.nominalRadius, 0) +
           " % off the nominal one, and lengths that are so "
           "far from what they should be prove nothing: check " +
           lengthsToCheck(measurement) + ".";
  }
  return std::nullopt;
}

std::vector<Finding> setupFindings(const Measurement& measurement, const SessionFit& fit) {
  std::vector<Finding> findings;
  judgeDistance(findings, measurement);
  judgeSides(findings, fit);
  judgeVerticalCircle(findings, measurement);
  for (const ArcMeasurement& arc : measurement.arcs) judgeSliders(findings, arc);
  return findings;
}

}  // namespace alidade
