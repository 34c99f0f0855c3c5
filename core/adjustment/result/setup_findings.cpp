#include "core/adjustment/result/setup_findings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/adjustment/joint/sighted_zeros.h"
#include "core/adjustment/result/reading_step.h"
#include "core/base/angle_text.h"
#include "core/observation/half_turn.h"
#include "core/observation/visits.h"
#include "core/session/zero_examiner.h"

namespace alidade {

using namespace setup_finding;

namespace {

constexpr double grosslyOff = 0.2;
constexpr double shortestFocus = 100;  // mm

void judgeDistance(std::vector<FitFinding>& findings, const Measurement& measurement) {
  if (measurement.distance >= shortestFocus) return;
  findings.push_back({Severity::Warning,
                      Place{.position = {}, .reading = {}, .field = "geometry.distance_mm"},
                      DistanceTooShort{measurement.distance, measurement.nominalRadius}});
}

/// Are most rows below the centre at 0°, or above it at 180°?
bool isUpsideDown(const ArcFit& arc) {
  const double up = halfTurnSign(arc.axisDeg);
  const auto wrong = std::ranges::count_if(
      arc.residuals, [&](const SightingResidual& row) { return up * std::sin(row.arcAngle) < 0; });
  return 2 * static_cast<std::size_t>(wrong) > arc.residuals.size();
}

void judgeSides(std::vector<FitFinding>& findings, const SessionFit& fit) {
  PlacesOnTheWrongSide wrong;
  std::size_t position = 0;
  for (const ArcFit& arc : fit.arcs) {
    if (!isUpsideDown(arc)) continue;
    if (wrong.axesDeg.empty()) position = arc.position;
    if (std::ranges::find(wrong.axesDeg, arc.axisDeg) == wrong.axesDeg.end())
      wrong.axesDeg.push_back(arc.axisDeg);
  }
  if (wrong.axesDeg.empty()) return;
  findings.push_back(
      {Severity::Warning, Place{.position = position, .reading = {}, .field = "axis_deg"}, std::move(wrong)});
}

/// The angle of a vertical reading from the horizon, 0…90°.
double fromHorizon(Angle vertical, VerticalCircle circle) {
  const double horizon = circle == VerticalCircle::Zenith ? 90 : 0;
  return std::abs(std::remainder(vertical.degrees() - horizon, 180));
}

/// Reports a zero that is nearer to the horizon of the other kind of circle.
void judgeVerticalCircle(std::vector<FitFinding>& findings, const Measurement& measurement) {
  for (const ArcMeasurement& arc : measurement.arcs)
    if (fromHorizon(arc.zeroVertical, measurement.verticalCircle) > steepestZero)
      findings.push_back(
          {Severity::Warning,
           Place{.position = arc.position, .reading = {}, .field = "pointing_zero.vertical"},
           ZeroOfOtherCircle{arc.axisDeg, arc.zeroVertical, measurement.verticalCircle, arc.repeat}});
}

void judgeZeros(std::vector<FitFinding>& findings, const Measurement& measurement) {
  const bool areExact =
      measurement.sigmaZeroHorizontal.radians() == 0 && measurement.sigmaZeroVertical.radians() == 0;
  if (measurement.pointingZeros != PointingZeros::Unstated || areExact || !hasAlikeZeros(measurement)) return;
  findings.push_back({Severity::Note,
                      Place{.position = {}, .reading = {}, .field = "geometry.pointing_zeros"},
                      ZerosAlike{measurement.arcs.size()}});
}

void judgeMarks(std::vector<FitFinding>& findings, const Measurement& measurement) {
  if (!areZerosInDoubt(measurement)) return;
  ZerosDiffer differ;
  const auto greatest = [](Angle so, Angle other) {
    return std::abs(other.radians()) > std::abs(so.radians()) ? other : so;
  };
  const ArcMeasurement& first = measurement.arcs.front();
  for (const ArcMeasurement& arc : measurement.arcs) {
    differ.horizontal = greatest(differ.horizontal, wrapped(arc.zeroHorizontal - first.zeroHorizontal));
    differ.vertical = greatest(differ.vertical, arc.zeroElevation - first.zeroElevation);
  }
  findings.push_back(
      {Severity::Note, Place{.position = {}, .reading = {}, .field = "geometry.zero_is"}, differ});
}

void judgeRounding(std::vector<FitFinding>& findings, const Measurement& measurement) {
  constexpr std::size_t mostRows = 20'000;  // more rows come from automatic tracking, which does not round
  if (measurement.rows > mostRows) return;
  for (const bool isVertical : {false, true}) {
    const Angle sigma = isVertical ? measurement.sigmaVertical : measurement.sigmaHorizontal;
    std::vector<Angle> readings;
    for (const ArcMeasurement& arc : measurement.arcs)
      for (const Sighting& sighting : arc.sightings) {
        const Angle zero = isVertical ? arc.zeroElevation : arc.zeroHorizontal;
        readings.push_back(zero + (isVertical ? sighting.e : sighting.a));
      }
    if (readings.empty()) continue;
    const std::optional<Angle> step = readingStep(readings, sigma * std::sqrt(12.0));
    if (!step) continue;
    findings.push_back({Severity::Warning,
                        Place{.position = {},
                              .reading = {},
                              .field = isVertical ? "instrument.sigma_vertical_arcsec"
                                                  : "instrument.sigma_horizontal_arcsec"},
                        ReadingsRounded{isVertical, *step, sigma}});
  }
}

/// Reports a zero that moved by more than the sightings of an unmoved zero differ in 999 of 1000 cases.
void judgeMoves(std::vector<FitFinding>& findings, const Measurement& measurement, const SessionFit& fit) {
  constexpr double farthest = 3.29;
  const double scale = measurement.zerosAreReadings ? std::max(1.0, fit.noise.factor) : 1;
  for (const ArcMeasurement& arc : measurement.arcs) {
    if (!arc.zero.moved) continue;
    const ZeroSightings::Move& move = *arc.zero.moved;
    const Angle sigmaHorizontal = measurement.sigmaZeroHorizontal * (scale * move.factor),
                sigmaVertical = measurement.sigmaZeroVertical * (scale * move.factor);
    const auto areFar = [&](Angle horizontal, Angle vertical) {
      return std::abs(horizontal.radians()) > farthest * sigmaHorizontal.radians() ||
             std::abs(vertical.radians()) > farthest * sigmaVertical.radians();
    };
    ZeroMoved moved{arc.axisDeg,     arc.repeat,    move.horizontal,        move.vertical,
                    sigmaHorizontal, sigmaVertical, measurement.zeroScatter};
    if (areFar(move.apartHorizontal, move.apartVertical))
      moved = {arc.axisDeg,         arc.repeat,        move.apartHorizontal * 2, move.apartVertical * 2,
               sigmaHorizontal * 2, sigmaVertical * 2, measurement.zeroScatter,  true};
    else if (!areFar(move.horizontal, move.vertical))
      continue;
    findings.push_back(
        {Severity::Warning,
         Place{.position = arc.position, .reading = {}, .field = "pointing_zero.after.horizontal"}, moved});
  }
}

void judgeZeroFaces(std::vector<FitFinding>& findings, const Measurement& measurement) {
  const auto found = std::ranges::find_if(measurement.arcs,
                                          [](const ArcMeasurement& arc) { return arc.zero.hasLeftOutFace; });
  if (found == measurement.arcs.end()) return;
  findings.push_back(
      {Severity::Note,
       Place{.position = found->position, .reading = {}, .field = "pointing_zero.face_2.horizontal"},
       ZeroFaceLeftOut{found->axisDeg, found->repeat}});
}

/// A slider value that differs from the first of its visit.
struct OtherSlider {
  std::size_t first, other;  // rows
  Angle apart;
};

std::vector<OtherSlider> otherSliders(const ArcMeasurement& arc) {
  std::vector<OtherSlider> others;
  if (!hasSliderReadings(arc)) return others;
  for (const Visit& visit : visitsOf(arc)) {
    const Sighting* first = sliderOf(arc, visit);
    for (const std::size_t i : visit.sightings) {
      const Sighting& row = arc.sightings[i];
      if (!row.slider || areEqualAsTyped(*row.slider, *first->slider)) continue;
      const Angle apart = Angle::fromRadians(std::abs(wrapped(*row.slider - *first->slider).radians()));
      others.push_back({first->row, row.row, apart});
    }
  }
  return others;
}

void judgeSliders(std::vector<FitFinding>& findings, const ArcMeasurement& arc) {
  const std::vector<OtherSlider> others = otherSliders(arc);
  if (others.empty()) return;
  const OtherSlider& most = *std::ranges::max_element(others, {}, &OtherSlider::apart);
  findings.push_back(
      {Severity::Warning, Place{.position = arc.position, .reading = most.other, .field = "slider"},
       SlidersDiffer{arc.axisDeg, most.first, most.other, most.apart, others.size() - 1, arc.repeat}});
}

}  // namespace

std::optional<LengthsInDoubt> doubtfulLengths(const Measurement& measurement,
                                              const std::vector<ArcFit>& arcs) {
  LengthsInDoubt doubt{.distance = measurement.distance, .nominalRadius = measurement.nominalRadius};
  if (measurement.distance < shortestFocus) return doubt;
  for (const ArcFit& arc : arcs) {
    const double off = std::abs(arc.circle.radius - measurement.nominalRadius);
    if (off <= grosslyOff * measurement.nominalRadius + 3 * arc.radiusSigma()) continue;
    doubt.radius = LengthsInDoubt::Radius{arc.axisDeg, 100 * off / measurement.nominalRadius, arc.repeat};
    return doubt;
  }
  return std::nullopt;
}

std::vector<FitFinding> setupFindings(const Measurement& measurement, const SessionFit& fit) {
  std::vector<FitFinding> findings;
  judgeDistance(findings, measurement);
  judgeSides(findings, fit);
  judgeVerticalCircle(findings, measurement);
  judgeZeros(findings, measurement);
  judgeMarks(findings, measurement);
  judgeMoves(findings, measurement, fit);
  judgeZeroFaces(findings, measurement);
  judgeRounding(findings, measurement);
  for (const ArcMeasurement& arc : measurement.arcs) judgeSliders(findings, arc);
  return findings;
}

}  // namespace alidade
