#include "core/session/slider_sense.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alidade {

namespace {

struct Seen {
  double slider = 0;    ///< reading minus the mean direction of all, rad
  double x = 0, y = 0;  ///< in the plane of the arc, in units of the distance
};

/// The places in the order of the slider's scale.
std::vector<Seen> seenAlongScale(const ArcMeasurement& arc) {
  double sine = 0, cosine = 0;
  for (const Sighting& row : arc.sightings)
    if (row.slider) {
      sine += std::sin(row.slider->radians());
      cosine += std::cos(row.slider->radians());
    }
  const Angle mean = Angle::fromRadians(std::atan2(sine, cosine));
  std::vector<Seen> places;
  for (const Sighting& row : arc.sightings)
    if (row.slider)
      places.push_back(
          {wrapped(*row.slider - mean).radians(), std::tan(row.a.radians()), std::tan(row.e.radians())});
  std::ranges::sort(places, {}, &Seen::slider);
  return places;
}

/// The sine of the angle by which the way from `a` over `b` to `c` turns to the left.
double turnOf(const Seen& a, const Seen& b, const Seen& c) {
  const double x = b.x - a.x, y = b.y - a.y, nextX = c.x - b.x, nextY = c.y - b.y;
  return (x * nextY - y * nextX) / (std::hypot(x, y) * std::hypot(nextX, nextY));
}

}  // namespace

bool runsAgainstSlider(const ArcMeasurement& arc) {
  constexpr std::size_t fewest = 5;
  constexpr double leastTurn = 0.05, most = 0.75;  // a twentieth radian; the share of places that say so
  const std::vector<Seen> places = seenAlongScale(arc);
  if (places.size() < fewest) return false;
  const double left = arc.axisDeg == 0 ? 1 : -1;
  const std::size_t apart = (places.size() - 1) / 3;  // far enough to tell a turn from noise
  int with = 0, against = 0;
  for (std::size_t i = 0; i + 2 * apart < places.size(); ++i) {
    const double turn = left * turnOf(places[i], places[i + apart], places[i + 2 * apart]);
    with += turn > leastTurn ? 1 : 0;
    against += turn < -leastTurn ? 1 : 0;
  }
  return against > 0 && against > most * (with + against);
}

}  // namespace alidade
