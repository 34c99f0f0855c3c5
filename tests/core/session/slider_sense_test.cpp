#include "core/session/slider_sense.h"

#include <gtest/gtest.h>

#include "core/session/hindrance.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade {
namespace {

/// Any zero of the scale, arcs of 60° to 150°, one face or two, one misread slider value.
Session read(const char* protocol, double zeroDeg, std::uint64_t seed) {
  Truth truth = drawTruth(seed);
  truth.sliderZero = Angle::fromDegrees(zeroDeg);
  return *simulate(*protocolByName(protocol), truth, seed);
}

void misread(Session& session) {
  session.positions[1].readings[3].slider = "12°30'00\"";
}

void turnRound(Session& session) {
  for (Position& position : session.positions)
    for (Reading& row : position.readings)
      row.slider = row.slider.starts_with('-') ? row.slider.substr(1) : "-" + row.slider;
}

TEST(SliderSense, IsWithTheArcAngleAt0AndAgainstItAt180) {
  for (const char* protocol : {"paper-slider", "full", "shifted-circle", "full-again"})
    for (const double zero : {0.0, 77.0, 179.9, -90.0}) {
      Session session = read(protocol, zero, 3);
      misread(session);
      const Examined examined = examine(session);
      for (const ArcMeasurement& arc : examined.measurement->arcs)
        EXPECT_FALSE(runsAgainstSlider(arc)) << protocol << zero;
      EXPECT_TRUE(examined.problems.empty()) << protocol << zero;
    }
}

// The other way round, no zero of the scale fits: the readings are left out, and a sentence says why.
TEST(SliderSense, RefusesTheOtherWay) {
  for (const double zero : {0.0, 77.0, 179.9, -90.0}) {
    Session session = read("paper-slider", zero, 4);
    turnRound(session);
    const Examined examined = examine(session);
    ASSERT_EQ(examined.problems.size(), session.positions.size()) << zero;
    EXPECT_EQ(examined.problems[1].where.position, 1u);
    EXPECT_TRUE(firstHindrance(session, examined.problems));
    for (const ArcMeasurement& arc : examined.measurement->arcs)
      for (const Sighting& row : arc.sightings) EXPECT_FALSE(row.slider);
  }
}

// A straight look at a short arc does not tell its sense.
TEST(SliderSense, IsUnknownOfFewPlaces) {
  Session session = read("paper-slider", 0, 5);
  turnRound(session);
  for (Position& position : session.positions) position.readings.resize(4);
  EXPECT_TRUE(examine(session).problems.empty());
}

}  // namespace
}  // namespace alidade
