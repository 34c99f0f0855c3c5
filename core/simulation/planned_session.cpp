#include "core/simulation/planned_session.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/angle_text.h"
#include "core/session/row_fields.h"
#include "core/simulation/simulate.h"

namespace alidade {

namespace {

constexpr int secondDecimals = 3;  // of an arcsecond

bool isUnread(const Reading& reading) {
  return !reading.excluded && reading.horizontal.empty() && reading.vertical.empty();
}

std::string circleText(Angle angle) {
  return formatDms(wrappedAsWritten(angle, secondDecimals, Angle::fromDegrees(180)), secondDecimals,
                   AngleSigns::Typewriter);
}

/// The value of a number field, if it is usable.
std::optional<double> numberOf(const char* field, const std::string& text) {
  const auto entry = numberEntry(field, text);
  return entry ? *entry : std::nullopt;
}

std::optional<int> wholeOf(const WholeRule& rule, const std::string& text) {
  const auto entry = wholeEntry(rule, text);
  return entry ? *entry : std::nullopt;
}

std::optional<Angle> angleOf(const AngleRule& rule, const std::string& text, VerticalCircle circle) {
  if (text.empty()) return std::nullopt;
  const auto entry = angleEntry(rule, text, circle);
  return entry ? *entry : std::nullopt;
}

/// The assumed guideway; absent if the geometry is unusable.
std::optional<Truth> nominal(const Session& session) {
  const auto distance = numberOf("geometry.distance_mm", session.geometry.distanceMm);
  const auto radius = numberOf("geometry.radius_mm", session.geometry.radiusMm);
  const auto circle = verticalCircleEntry(session.geometry.verticalCircle);
  if (!distance || !radius || !circle) return std::nullopt;
  Truth truth;
  truth.distance = *distance;
  truth.radius = *radius;
  truth.verticalCircle = *circle;
  truth.verticalZero = *circle == VerticalCircle::Zenith ? Angle::fromDegrees(90) : Angle();
  return truth;
}

/// Evenly spaced places of a position's points.
class EvenPlaces {
 public:
  explicit EvenPlaces(const Position& position) {
    for (std::size_t i = 0; i < position.readings.size(); ++i) m_points.push_back(pointOf(position, i));
    std::ranges::sort(m_points);
    m_points.erase(std::unique(m_points.begin(), m_points.end()), m_points.end());
  }

  Angle at(const Position& position, std::size_t row) const {
    constexpr double first = 10, last = 170;
    const auto index = std::ranges::lower_bound(m_points, pointOf(position, row)) - m_points.begin();
    const auto gaps = std::max<std::size_t>(m_points.size(), 2) - 1;
    return Angle::fromDegrees(first +
                              (last - first) * static_cast<double>(index) / static_cast<double>(gaps));
  }

 private:
  std::vector<int> m_points;

  /// The point of a row; if the row states none, the number of the row, from 1.
  static int pointOf(const Position& position, std::size_t row) {
    return wholeOf(pointRule, position.readings[row].point).value_or(static_cast<int>(row) + 1);
  }
};

void plan(Position& position, Truth truth) {
  const auto axis = axisEntry(position.axisDeg);
  if (!axis || std::ranges::none_of(position.readings, isUnread)) return;
  PointingZero& zero = position.zero;
  if (zero.horizontal.empty()) zero.horizontal = circleText(Angle());
  if (zero.vertical.empty()) zero.vertical = circleText(truth.verticalZero);
  const auto horizontal = angleOf(horizontalRule, zero.horizontal, truth.verticalCircle);
  const auto vertical = angleOf(verticalRule, zero.vertical, truth.verticalCircle);
  if (!horizontal || !vertical) return;
  truth.verticalZero = *vertical;
  const PerfectReadings perfect(truth, *axis, *horizontal);
  const EvenPlaces even(position);
  for (std::size_t row = 0; row < position.readings.size(); ++row) {
    Reading& reading = position.readings[row];
    if (!isUnread(reading)) continue;
    const Angle place =
        angleOf(sliderRule, reading.slider, truth.verticalCircle).value_or(even.at(position, row));
    const CircleReadings circles = perfect.target(place, wholeOf(faceRule, reading.face).value_or(1), {});
    if (reading.point.empty()) reading.point = std::to_string(row + 1);
    reading.horizontal = circleText(circles.horizontal);
    reading.vertical = circleText(circles.vertical);
  }
}

}  // namespace

Session withPlannedReadings(Session session) {
  const std::optional<Truth> truth = nominal(session);
  if (!truth) return session;
  for (Position& position : session.positions) plan(position, *truth);
  return session;
}

}  // namespace alidade
