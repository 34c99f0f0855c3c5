#include "core/adjustment/arc/robust_start.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/adjustment/numerics/algebraic_circle.h"
#include "core/base/statistics.h"
#include "core/observation/half_turn.h"
#include "core/observation/zero_line.h"

namespace alidade {

namespace {

using Points = std::vector<PlanePoint<double>>;

constexpr std::size_t fewestRows = 6;
constexpr std::size_t mostTriples = 150;
constexpr double apartFrom = 6;  ///< in units of the scatter of the majority

Points sightedPoints(const Measurement& measurement, const ArcMeasurement& arc) {
  Points points;
  const ZeroLine line(measurement, arc);
  for (const Sighting& sighting : arc.sightings) points.push_back(line.sightedPoint(sighting));
  return points;
}

double distanceTo(const Circle& circle, const PlanePoint<double>& point) {
  return std::abs(std::hypot(point.x - circle.x, point.y - circle.y) - circle.radius);
}

/// The value that ⌊n/2⌋ + 2 sizes do not exceed: the most robust choice for three fitted numbers.
double majorityBound(std::vector<double> sizes) {
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2 + 1);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

double majorityDistance(const Circle& circle, const Points& points) {
  std::vector<double> distances;
  for (const auto& point : points) distances.push_back(distanceTo(circle, point));
  return majorityBound(std::move(distances));
}

/// At most 120 rows at regular intervals: more rows do not improve the start.
Points sample(const Points& points) {
  constexpr std::size_t most = 120;
  if (points.size() <= most) return points;
  Points some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(points[i * points.size() / most]);
  return some;
}

/// Returns the circle through three points that is nearest to the majority of all points.
std::optional<Circle> bestOfTriples(const Points& points) {
  std::optional<Circle> best;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = points.size();
  // Triples spread over the arc: the offset of j changes with every third triple, that of k every seventh.
  for (std::size_t t = 0; t < mostTriples; ++t) {
    const std::size_t i = t % n, j = (i + 1 + n / 4 + t / 3 % (n / 2)) % n,
                      k = (j + 1 + n / 4 + t / 7 % (n / 2)) % n;
    if (i == j || j == k || i == k) continue;
    const auto circle = algebraicCircle({points[i], points[j], points[k]});
    if (!circle) continue;
    const double distance = majorityDistance(*circle, points);
    if (distance < least) {
      least = distance;
      best = circle;
    }
  }
  return best;
}

/// The σ of a normal scatter of which half lies within ± `bound`, with a correction for few rows.
double scatterOf(double bound, std::size_t rows) {
  return 1.4826 * (1 + 5 / static_cast<double>(rows - 3)) * bound;
}

void markSliders(RobustStart& start, const ArcMeasurement& arc, const Points& points, double floor) {
  std::vector<std::size_t> rows;
  std::vector<Angle> zeros;
  MeanDirection mean;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!arc.sightings[i].slider || std::ranges::binary_search(start.apart, i)) continue;
    const double s = sliderCoordinateOf(nearestArcAngle(start.circle, points[i]), arc.axisDeg);
    rows.push_back(i);
    zeros.push_back(*arc.sightings[i].slider - Angle::fromRadians(s));
    mean.add(zeros.back());
  }
  if (rows.size() < fewestRows) return;
  std::vector<double> offsets;  // from the mean direction, since zeros near 180° lie on both sides of it
  const Angle middle = mean.value();
  for (const Angle& one : zeros) offsets.push_back(wrapped(one - middle).radians());
  const double zero = medianOf(offsets);
  std::vector<double> sizes;
  for (double& offset : offsets) {
    offset = std::abs(wrapped(Angle::fromRadians(offset - zero)).radians());
    sizes.push_back(offset);
  }
  const double bound = apartFrom * std::max(floor, scatterOf(majorityBound(sizes), rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (offsets[i] > bound) start.sliderApart.push_back(rows[i]);
}

}  // namespace

RobustStart robustStart(const Measurement& measurement, const ArcMeasurement& arc) {
  const Points points = sightedPoints(measurement, arc);
  RobustStart start;
  const auto usual = algebraicCircle(points);
  start.circle = usual.value_or(Circle{0, 0, measurement.nominalRadius});
  if (points.size() < fewestRows) return start;
  const Points some = sample(points);
  auto circle = bestOfTriples(some);
  if (!circle) return start;
  // The stated noise of the circles in mm: the least scatter that is assumed.
  const double floor =
      measurement.distance * std::max(measurement.sigmaHorizontal, measurement.sigmaVertical).radians();
  double scatter = 0;
  for (int pass = 0; pass < 4; ++pass) {
    scatter = std::max(floor, scatterOf(majorityDistance(*circle, points), points.size()));
    Points near;
    for (const auto& point : points)
      if (distanceTo(*circle, point) < 3 * scatter) near.push_back(point);
    const auto refined = algebraicCircle(near);
    if (!refined) return start;
    circle = refined;
  }
  start.circle = *circle;
  scatter = std::max(floor, scatterOf(majorityDistance(start.circle, points), points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distanceTo(start.circle, points[i]) > apartFrom * scatter) start.apart.push_back(i);
  markSliders(start, arc, points, measurement.sigmaSlider.radians());
  return start;
}

}  // namespace alidade
