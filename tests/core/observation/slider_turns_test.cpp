#include "core/observation/slider_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/observation/half_turn.h"

namespace alidade {
namespace {

double inDegrees(double radians) {
  return Angle::fromRadians(radians).degrees();
}

/// s of each place, degrees, after its arc angle was found from a direction and unwrapped. Where `isRead`,
/// the slider reads `zero` more than s, on a scale from 0° to 360°.
std::vector<double> unwrapped(const std::vector<double>& places, int axisDeg, double zero = 0,
                              const std::vector<bool>& isRead = {}) {
  std::vector<Sighting> rows(places.size());
  std::vector<const Sighting*> sliders;
  std::vector<double> angles;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double phi = arcAngleOf(Angle::fromDegrees(places[i]).radians(), axisDeg);
    angles.push_back(std::atan2(std::sin(phi), std::cos(phi)));
    rows[i].slider = wrapped(Angle::fromDegrees(places[i] + zero), Angle::fromDegrees(180));
    sliders.push_back(isRead.empty() || isRead[i] ? &rows[i] : nullptr);
  }
  unwrapAlongSlider(angles, sliders, axisDeg);
  std::vector<double> s;
  for (const double phi : angles) s.push_back(inDegrees(sliderCoordinateOf(phi, axisDeg)));
  return s;
}

void expectSame(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

TEST(SliderTurns, RunOnBeyondHalfATurn) {
  const std::vector<double> places{200, 20, 60, 100, 140, 180, 240};
  for (const int axisDeg : {0, 180})
    for (const double zero : {0.0, 35.0, 100.0}) expectSame(unwrapped(places, axisDeg, zero), places);
}

TEST(SliderTurns, RunOnThroughTheScalesOwnZero) {
  const std::vector<double> places{-5, 30, 65, 100, 135, 170, 185};
  for (const int axisDeg : {0, 180}) expectSame(unwrapped(places, axisDeg), places);
}

// For an arc around the full circle, any gap may be the open side; the scale begins at its 0°.
TEST(SliderTurns, FollowTheScaleAllButRoundTheCircle) {
  std::vector<double> places;
  for (double s = 0; s < 360; s += 22.5) places.push_back(s);
  expectSame(unwrapped(places, 0), places);
}

TEST(SliderTurns, LeaveLessThanHalfATurnAsItIs) {
  const std::vector<double> places{-170, -120, -60, -10};  // upside down, and reported as such
  expectSame(unwrapped(places, 0), places);
}

TEST(SliderTurns, LeaveWhatHasNoSliderReading) {
  expectSame(unwrapped({20, 200, 200, 90}, 0, 0, {true, true, false, true}), {20, 200, -160, 90});
}

}  // namespace
}  // namespace alidade
