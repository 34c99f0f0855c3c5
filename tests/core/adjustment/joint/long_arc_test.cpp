#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/result/session_fit.h"
#include "core/observation/half_turn.h"
#include "core/session/measurement.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

// Arcs of more than half a turn, in all parts of a fit.

namespace alidade {
namespace {

/// Both faces there and back with slider readings, from 20° to `last`.
Protocol upTo(double last) {
  Protocol protocol = *protocolByName("full");
  protocol.first = Angle::fromDegrees(20);
  protocol.step = Angle::fromDegrees((last - 20) / (protocol.points - 1));
  return protocol;
}

class LongArc : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(Ends, LongArc, testing::Values(170.0, 200.0, 290.0));

// Without noise the fit finds the true scale, which its prior reduces by the share (σ/5e-4)².
TEST_P(LongArc, TellsTheScaleOfTheSlider) {
  Truth truth = drawTruth(3);
  truth.effects = {{ErrorTerm::SliderScale, 4e-4}};
  Measurement measurement = *examine(*simulateWithoutNoise(upTo(GetParam()), truth, 3)).measurement;
  measurement.effects = {"slider_scale"};
  const SessionFit fit = fitSession(measurement);
  const double drawn = 4e-4 * std::pow(fit.effects.at(0).sigma / 5e-4, 2);
  EXPECT_NEAR(fit.effects.at(0).value, 4e-4 - drawn, 4e-8 + 0.1 * drawn);
  EXPECT_NEAR(fit.intersection->value, truth.intersection, 3e-4);
}

// Both the fast adjustment and the general one are tested; readings of 1e-6″ leave 1e-6 rad.
TEST_P(LongArc, HasItsAnglesWithoutASeam) {
  const Protocol protocol = upTo(GetParam());
  Measurement measurement = *examine(*simulateWithoutNoise(protocol, drawTruth(5), 5)).measurement;
  for (const bool isGeneral : {false, true}) {
    measurement.effects.clear();
    if (isGeneral) measurement.effects = {"collimation"};
    const SessionFit fit = fitSession(measurement);
    for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc)
      for (std::size_t i = 0; i < measurement.arcs[arc].sightings.size(); ++i) {
        const double s = sliderCoordinateOf(fit.joint.arcAngles[arc][i], measurement.arcs[arc].axisDeg);
        EXPECT_NEAR(s, measurement.arcs[arc].sightings[i].slider->radians(), 1e-6);
      }
  }
}

// Without slider readings, too, places to both sides of 180° are neighbours.
TEST(LongArcWithoutSlider, HasNoSeamWithinTheGuideway) {
  const Measurement read = *examine(*simulateWithoutNoise(upTo(200), drawTruth(5), 5)).measurement;
  for (const bool isGeneral : {false, true}) {
    Measurement measurement = read;
    if (isGeneral) measurement.effects = {"collimation"};
    for (ArcMeasurement& arc : measurement.arcs)
      for (Sighting& sighting : arc.sightings) sighting.slider.reset();
    const SessionFit fit = fitSession(measurement);
    for (std::size_t arc = 0; arc < measurement.arcs.size(); ++arc)
      for (std::size_t i = 0; i < measurement.arcs[arc].sightings.size(); ++i) {
        const double s = sliderCoordinateOf(fit.joint.arcAngles[arc][i], measurement.arcs[arc].axisDeg);
        EXPECT_NEAR(s, read.arcs[arc].sightings[i].slider->radians(), 1e-6);
      }
  }
}

}  // namespace
}  // namespace alidade
