#include "core/adjustment/result/two_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

/// The instrument's errors in arcseconds.
struct Errors {
  double collimation = 0, trunnionTilt = 0, index = 0;
};

Angle degrees(double value) {
  return Angle::fromDegrees(value);
}

/// Returns readings in both faces at each of these elevations (degrees), by the textbook's formulas,
/// independent of the model.
Measurement twoFaceReadings(const Errors& errors, const std::vector<double>& elevations,
                            VerticalCircle circle = VerticalCircle::Zenith) {
  Measurement measurement = test::usualMeasurement();
  measurement.verticalCircle = circle;
  ArcMeasurement arc;
  const double down = circle == VerticalCircle::Zenith ? 1 : -1;
  for (const double elevation : elevations) {
    const double e = elevation * std::numbers::pi / 180;
    const double change = errors.collimation / std::cos(e) + errors.trunnionTilt * std::tan(e);
    for (const int face : {1, 2}) {
      const double side = face == 1 ? 1 : -1;
      Sighting sighting;
      sighting.row = arc.sightings.size();
      sighting.point = static_cast<int>(arc.sightings.size() / 2) + 1;
      sighting.face = face;
      sighting.a = degrees(elevation / 2) + Angle::fromArcseconds(side * change);
      sighting.e = degrees(elevation) - Angle::fromArcseconds(side * down * errors.index);
      arc.sightings.push_back(sighting);
    }
  }
  measurement.arcs = {arc};
  return measurement;
}

// Nine digits of an arcsecond: the differences of readings of some degrees lose about five of sixteen.
constexpr double rounding = 1e-9;

TEST(TwoFaces, FindsCollimationTiltAndIndexOfExactReadings) {
  const auto faces = compareFaces(twoFaceReadings({25, -40, 12}, {-9, -4, 0, 3, 8}));
  ASSERT_TRUE(faces && faces->trunnionTilt);
  EXPECT_NEAR(faces->collimation.value.arcseconds(), 25, rounding);
  EXPECT_NEAR(faces->trunnionTilt->value.arcseconds(), -40, rounding);
  EXPECT_NEAR(faces->index.value.arcseconds(), 12, rounding);
  EXPECT_EQ(faces->horizontal.degreesOfFreedom, 3);
  EXPECT_EQ(faces->vertical.degreesOfFreedom, 4);
  ASSERT_EQ(faces->visits.size(), 5U);
  const FaceDifference& last = faces->visits.back();
  EXPECT_EQ(last.faceOne, 8U);
  EXPECT_EQ(last.faceTwo, 9U);
  EXPECT_NEAR(last.elevation.degrees(), 8, 1e-12);
  const double e = 8 * std::numbers::pi / 180;
  EXPECT_NEAR(last.doubleCollimation.arcseconds(), 2 * (25 / std::cos(e) - 40 * std::tan(e)), rounding);
  EXPECT_NEAR(last.fromCourse.arcseconds(), 0, rounding);
}

TEST(TwoFaces, CountTheIndexAsAnExcessOfTheReadingOnEitherCircle) {
  const auto faces = compareFaces(twoFaceReadings({0, 0, 12}, {-9, 0, 9}, VerticalCircle::Elevation));
  ASSERT_TRUE(faces);
  EXPECT_NEAR(faces->index.value.arcseconds(), 12, rounding);
}

// Two visits each at ±10°: w = 2c·cos e/2 has σ = 2″·cos e/√2, the mean of four half of it, the slope 1/sin
// 10° times that of the mean. An index has σ = 2″/√2.
TEST(TwoFaces, StateUncertaintiesOfTheStatedNoiseWhereReadingsScatterImprobablyLittle) {
  const auto faces = compareFaces(twoFaceReadings({5, 5, 5}, {10, -10, 10, -10}));
  ASSERT_TRUE(faces && faces->trunnionTilt);
  const double e = 10 * std::numbers::pi / 180, sigma = 2 * std::cos(e) / std::sqrt(2.0) / 2;
  EXPECT_NEAR(faces->collimation.sigma.arcseconds(), sigma, 1e-9);
  EXPECT_NEAR(faces->trunnionTilt->sigma.arcseconds(), sigma / std::sin(e), 1e-9);
  EXPECT_NEAR(faces->index.sigma.arcseconds(), 2 / std::sqrt(2.0) / 2, 1e-9);
}

// Alternating ±8″ on the horizontal reading of face 1 at one elevation: a mean of zero, Σv² = 6·64, each
// difference with variance 2·2², so s0² = 6·64/8/5.
TEST(TwoFaces, ScaleUncertaintiesByTheScatter) {
  Measurement measurement = twoFaceReadings({}, {0, 0, 0, 0, 0, 0});
  for (std::size_t i = 0; i < 12; i += 2) {
    Sighting& sighting = measurement.arcs[0].sightings[i];
    sighting.a = sighting.a + Angle::fromArcseconds(i % 4 == 0 ? 8 : -8);
  }
  const auto faces = compareFaces(measurement);
  ASSERT_TRUE(faces);
  const double ratio = std::sqrt(6.0 * 64 / 8 / 5);
  EXPECT_NEAR(faces->horizontal.ratio(), ratio, 1e-9);
  EXPECT_NEAR(faces->collimation.sigma.arcseconds(), ratio * 2 / std::sqrt(2.0 * 6), 1e-9);
}

TEST(TwoFaces, TakeTheMeanWhereElevationsTellNoTilt) {
  for (const auto& elevations : {std::vector<double>{6}, {6, -6}, {6, 6, 6}}) {
    const auto faces = compareFaces(twoFaceReadings({25, 0, 0}, elevations));
    ASSERT_TRUE(faces);
    EXPECT_FALSE(faces->trunnionTilt);
    EXPECT_NEAR(faces->collimation.value.arcseconds(), 25, rounding);
  }
}

TEST(TwoFaces, NeedBothFacesOfOneVisit) {
  EXPECT_FALSE(compareFaces(test::usualMeasurement()));
  Measurement measurement = twoFaceReadings({25, 0, 0}, {3, 6});
  ArcMeasurement& arc = measurement.arcs[0];
  arc.sightings.pop_back();
  ASSERT_TRUE(compareFaces(measurement));
  EXPECT_EQ(compareFaces(measurement)->visits.size(), 1U);
  arc.sightings[0].round = 2;  // another visit of the slider
  EXPECT_FALSE(compareFaces(measurement));
}

// Collimation and index of the independent ray tracer, whose collimation has the opposite sign. Sessions
// without these errors give zero. Tolerance: 4 σ.
TEST(TwoFaces, TellTheRayTracersInstrument) {
  const std::map<std::string, Errors> counts = {
      {"none", {}}, {"collimation", {-1, 0, 0}}, {"vertical_index", {0, 0, 1}}};
  int compared = 0;
  for (const test::Trial& trial : test::trials()) {
    const auto count = counts.find(trial.kind);
    const auto faces = compareFaces(trial.measurement);
    if (count == counts.end() || !faces) continue;
    SCOPED_TRACE(trial.id + " " + trial.kind);
    const double c = count->second.collimation * trial.effects.value("collimation", 0.0);
    const double j = count->second.index * trial.effects.value("index", 0.0);
    EXPECT_NEAR(faces->collimation.value.arcseconds(), c, 4 * faces->collimation.sigma.arcseconds());
    EXPECT_NEAR(faces->index.value.arcseconds(), j, 4 * faces->index.sigma.arcseconds());
    ASSERT_TRUE(faces->trunnionTilt);
    EXPECT_NEAR(faces->trunnionTilt->value.arcseconds(), 0, 4 * faces->trunnionTilt->sigma.arcseconds());
    ++compared;
  }
  EXPECT_GE(compared, 4);
}

// The joint adjustment estimates the same errors from the same differences, with the exact model and its own
// derivatives. Its priors of 30″ change them by less than a thousandth.
TEST(TwoFaces, MeetTheJointAdjustmentsEstimates) {
  Measurement measurement = test::trialMeasurement("two-face");
  const auto faces = compareFaces(measurement);
  ASSERT_TRUE(faces && faces->trunnionTilt);
  measurement.effects = {"collimation", "trunnion_tilt", "vertical_index"};
  const SessionFit fit = fitSession(measurement);
  ASSERT_EQ(fit.effects.size(), 3U);
  const InstrumentError errors[] = {faces->collimation, *faces->trunnionTilt, faces->index};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(fit.effects[i].value, errors[i].value.arcseconds(), 0.1 * errors[i].sigma.arcseconds())
        << fit.effects[i].effect;
}

}  // namespace
}  // namespace alidade
