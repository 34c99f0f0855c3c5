#include "core/observation/slider_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/observation/half_turn.h"

namespace alidade {

namespace {

struct SliderPlace {
  double reading, s;
  double* arcAngle;
};

/// The arc begins after the widest gap between readings. Returns the first reading after the gap, rad: from
/// this reading on, a full turn is subtracted. Infinite if the arc begins at the smallest reading. A gap
/// below 45° is ignored, as it may lie between two visits.
double turnoverOf(std::vector<SliderPlace>& places) {
  constexpr double smallest = std::numbers::pi / 4;
  std::ranges::sort(places, {}, &SliderPlace::reading);
  double widest = std::max(smallest, 2 * std::numbers::pi - places.back().reading + places.front().reading);
  double turnover = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double gap = places[i].reading - places[i - 1].reading;
    if (gap <= widest) continue;
    widest = gap;
    turnover = places[i].reading;
  }
  return turnover;
}

double near(double angle, double centre) {
  return wrapped(Angle::fromRadians(angle), Angle::fromRadians(centre)).radians();
}

}  // namespace

double sliderZero(std::span<const double> arcAngles, std::span<const Sighting* const> sliders, int axisDeg) {
  MeanDirection zero;
  for (std::size_t i = 0; i < arcAngles.size(); ++i)
    if (sliders[i])
      zero.add(*sliders[i]->slider - Angle::fromRadians(sliderCoordinateOf(arcAngles[i], axisDeg)));
  return zero.value().radians();
}

void unwrapAlongSlider(std::span<double> arcAngles, std::span<const Sighting* const> sliders, int axisDeg) {
  std::vector<SliderPlace> places;
  for (std::size_t i = 0; i < arcAngles.size(); ++i)
    if (sliders[i])
      places.push_back(
          {sliders[i]->slider->radians(), sliderCoordinateOf(arcAngles[i], axisDeg), &arcAngles[i]});
  if (places.empty()) return;
  const auto [least, most] = std::ranges::minmax(places, {}, &SliderPlace::s);
  if (most.s - least.s < std::numbers::pi) return;
  const double turnover = turnoverOf(places), zero = sliderZero(arcAngles, sliders, axisDeg);
  double sum = 0;
  for (SliderPlace& place : places) {
    const double turn = place.reading < turnover ? 0 : 2 * std::numbers::pi;
    place.s = near(place.s, place.reading - turn - zero);
    sum += place.s;
  }
  const double mean = sum / static_cast<double>(places.size());
  const double turns = near(mean, std::numbers::pi / 2) - mean;
  for (const SliderPlace& place : places) *place.arcAngle = arcAngleOf(place.s + turns, axisDeg);
}

}  // namespace alidade
