#include "core/observation/own_model.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "core/observation/half_turn.h"
#include "core/observation/perfect_theodolite.h"

namespace alidade {

namespace {

/// Returns the derivative: for a smooth function the mean of both differences; near a jump, the difference on
/// the side without the jump.
double slope(double before, double here, double after, double step) {
  const double back = (here - before) / step, on = (after - here) / step;
  if (!std::isfinite(back) || !std::isfinite(on)) return 0;
  constexpr double smooth = 1e-2;
  if (std::abs(on - back) < smooth * (1 + std::abs(back) + std::abs(on))) return (back + on) / 2;
  return std::abs(back) < std::abs(on) ? back : on;
}

constexpr double shortStep = 1e-6;  // rad: rounding and third derivatives stay below 1e-9

}  // namespace

FormulaArguments argumentsAt(const OwnPlace& place, double a, double e) {
  FormulaArguments at = place.row;
  const int face = at.face > 0 ? 1 : 2;
  at.a = a;
  at.e = e;
  const double circle = place.horizontalZero + a + (face == 1 ? 0 : std::numbers::pi);
  at.horizontalCircle = wrapped(Angle::fromRadians(circle), Angle::fromDegrees(180)).radians();
  at.verticalCircle = verticalCircleReading(e, face, place.circle);
  return at;
}

OwnModel::OwnModel(std::shared_ptr<const OwnEffects> effects) : m_effects(std::move(effects)) {
  for (std::size_t entry = 0; m_effects && entry < m_effects->entries().size(); ++entry) {
    const OwnEntry& own = m_effects->entries()[entry];
    m_evaluators.emplace_back(own.formula);
    for (std::size_t line = 0; line < own.formula.lines.size(); ++line) {
      const FormulaLine& of = own.formula.lines[line];
      m_lines.push_back({entry, line, of.carrier, of.actsOnZeros, own.source.turnsWithFace, of.amplitudes});
    }
  }
}

template <typename Slopes>
std::span<const OwnShare> OwnModel::shares(bool ofCircles, const OwnPlace& place,
                                           const Slopes& slopes) const {
  m_shares.clear();
  for (const Line& line : m_lines) {
    if (isOfCircles(line.carrier) != ofCircles || (place.isZero && !line.actsOnZeros)) continue;
    const double side = line.turnsWithFace && ofCircles ? place.row.face : 1;
    for (const std::size_t amplitude : line.amplitudes) {
      const ErrorTerm term = m_effects->entries()[line.entry].terms[amplitude];
      OwnShare share{.term = term, .carrier = line.carrier};
      slopes(share, [&](const FormulaArguments& at) {
        return side * m_evaluators[line.entry].value(line.line, amplitude, at);
      });
      if (std::isfinite(share.value))
        m_shares.push_back(share);
      else
        ++m_notFinite;
    }
  }
  return m_shares;
}

std::span<const OwnShare> OwnModel::ofGuideway(const OwnPlace& place, const PlanePoint<double>& centre,
                                               double radius, double distance, double phi,
                                               int axisDeg) const {
  std::array<FormulaArguments, 3> at;  // before, here, behind
  for (int i = 0; i < 3; ++i) {
    const double there = phi + (i - 1) * shortStep;
    const Direction<double> direction =
        observe(targetOnArc(centre.x, centre.y, radius, there), distance, VerticalAngleRelation::Exact);
    FormulaArguments& own = at[static_cast<std::size_t>(i)] =
        argumentsAt(place, direction.a, direction.e + place.zeroElevation);
    own.s = sliderCoordinateOf(there, axisDeg);
  }
  return shares(false, place, [&](OwnShare& share, const auto& valueAt) {
    share.value = valueAt(at[1]);
    share.byArcAngle = slope(valueAt(at[0]), share.value, valueAt(at[2]), shortStep);
  });
}

std::span<const OwnShare> OwnModel::ofCircles(const OwnPlace& place, double a, double e) const {
  const auto at = [&](double a1, double e1, double s1) {
    FormulaArguments arguments = argumentsAt(place, a1, e1);
    arguments.s += s1;
    return arguments;
  };
  constexpr double d = shortStep;
  const FormulaArguments here = at(a, e, 0), left = at(a - d, e, 0), right = at(a + d, e, 0),
                         below = at(a, e - d, 0), above = at(a, e + d, 0), before = at(a, e, -d),
                         behind = at(a, e, d);
  const double turn = place.row.position;  // s grows with φ at axis 0°, and against it at 180°
  return shares(true, place, [&](OwnShare& share, const auto& valueAt) {
    share.value = valueAt(here);
    share.byA = slope(valueAt(left), share.value, valueAt(right), d);
    share.byE = slope(valueAt(below), share.value, valueAt(above), d);
    share.byArcAngle = turn * slope(valueAt(before), share.value, valueAt(behind), d);
  });
}

OwnPlace OwnModel::zeroOf(const Measurement& measurement, const ArcMeasurement& arc) const {
  return {.model = this,
          .row = {.t = arc.zero.elapsed, .position = halfTurnSign(arc.axisDeg)},
          .horizontalZero = arc.zeroHorizontal.radians(),
          .zeroElevation = arc.zeroElevation.radians(),
          .circle = measurement.verticalCircle,
          .isZero = true};
}

OwnPlace OwnModel::placeOf(const Measurement& measurement, const ArcMeasurement& arc, const Sighting& row,
                           double phi) const {
  OwnPlace place = zeroOf(measurement, arc);
  place.isZero = row.isZero;
  place.row.t = row.elapsed;
  place.row.face = row.face == 1 ? 1 : -1;
  if (row.isZero) return place;
  place.row.s = sliderCoordinateOf(phi, arc.axisDeg);
  place.row.round = row.round;
  place.row.leg = row.round % 2 == 1 ? 1 : -1;
  return place;
}

}  // namespace alidade
