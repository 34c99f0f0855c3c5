#include "core/observation/zero_line.h"

#include <cmath>

namespace alidade {

SpacePoint<double> ZeroLine::lineOfSight(const Direction<double>& fromHorizon) const {
  const double right = std::tan(fromHorizon.a);
  const double horizontal = m_relation == VerticalAngleRelation::Exact ? std::sqrt(1 + right * right) : 1;
  return {right, horizontal * std::tan(fromHorizon.e), -1};
}

PlanePoint<double> ZeroLine::sightedPoint(const Direction<double>& reduced) const {
  const SpacePoint<double> sight = lineOfSight({reduced.a, reduced.e + m_elevation});
  if (m_plane == ArcPlane::Vertical)
    return {m_distance * sight.x, m_distance * (sight.y - std::tan(m_elevation))};
  const double sine = std::sin(m_elevation), cosine = std::cos(m_elevation);
  const double up = sight.y * cosine + sight.z * sine, forward = sight.y * sine - sight.z * cosine;
  return {m_distance * sight.x / forward, m_distance * up / forward};
}

Direction<double> ZeroLine::observe(const PlanePoint<double>& point) const {
  return observeInSpace(SpacePoint<double>{point.x, point.y, -m_distance});
}

Direction<double> ZeroLine::observeInSpace(const SpacePoint<double>& point) const {
  const SpacePoint<double> target = roomFromZeroLine(point, m_distance, m_elevation, m_plane);
  Direction<double> seen = alidade::observe(PlanePoint<double>{target.x, target.y}, -target.z, m_relation);
  seen.e -= m_elevation;
  return seen;
}

Direction<double> ZeroLine::levelled(const Direction<double>& reduced) const {
  if (m_elevation == 0) return reduced;
  if (m_plane == ArcPlane::Vertical) return {reduced.a, reduced.e + m_elevation};
  return alidade::observe(sightedPoint(reduced), m_distance, m_relation);
}

double ZeroLine::height() const {
  return m_plane == ArcPlane::Vertical ? m_distance * std::tan(m_elevation) : 0;
}

void sightPerfectly(Sighting& sighting, const ZeroLine& line, const Circle& circle, double phi) {
  const Direction<double> seen = line.observe(targetOnArc(circle.x, circle.y, circle.radius, phi));
  sighting.a = Angle::fromRadians(seen.a);
  sighting.e = Angle::fromRadians(seen.e);
}

}  // namespace alidade
