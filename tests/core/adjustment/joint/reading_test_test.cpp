#include "core/adjustment/joint/reading_test.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/joint/fast_joint_fit.h"
#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

// Critical values of Student's t from the incomplete beta function, in 20 digits.
TEST(ReadingTest, SharesTheRiskOutOverAllTests) {
  const auto bound = [](int tests, int freedom) {
    return ReadingTest{.tests = tests, .degreesOfFreedom = freedom}.criticalValue();
  };
  EXPECT_NEAR(bound(1, 2), 9.924843, 1e-5);
  EXPECT_NEAR(bound(34, 4), 11.796336, 1e-5);
  EXPECT_NEAR(bound(34, 27), 4.152190, 1e-5);
  EXPECT_NEAR(bound(10000, 50), 5.571798, 1e-5);
  EXPECT_TRUE(std::isinf(bound(34, 0)));
}

// The noncentrality at which t exceeds the critical value in 80 % of cases, the distribution integrated
// numerically with 20 digits. The approximation errs by the amounts in its header.
TEST(ReadingTest, DetectsTheShiftOfANoncentralT) {
  struct Exact {
    int tests, freedom;
    double shift, tolerance;
  };
  for (const auto& [tests, freedom, shift, tolerance] :
       {Exact{34, 1, 2760.44, 0.05}, Exact{34, 2, 73.7922, 0.022}, Exact{34, 4, 14.5360, 0.01},
        Exact{100, 5, 13.6020, 0.01}, Exact{10, 12, 5.33901, 0.002}, Exact{34, 27, 5.07862, 0.0004},
        Exact{10000, 50, 6.50625, 0.0002}, Exact{100, 100, 4.91719, 0.0001}}) {
    const double found = ReadingTest{.tests = tests, .degreesOfFreedom = freedom}.detectableShift(0.80);
    EXPECT_GE(found, shift * (1 - 1e-6)) << freedom;
    EXPECT_LE(found, shift * (1 + tolerance)) << freedom;
  }
  EXPECT_TRUE(std::isinf(ReadingTest{.degreesOfFreedom = 0}.detectableShift(0.80)));
}

// If the scale is almost known the test is Baarda's, with the normal quantiles of any table.
TEST(ReadingTest, IsBaardasInKnownNoise) {
  constexpr int many = 100'000'000;
  const auto shift = [](double risk, double power) {
    return ReadingTest{.risk = risk, .degreesOfFreedom = many}.detectableShift(power);
  };
  EXPECT_NEAR(shift(0.001, 0.80), 4.13, 0.005);
  EXPECT_NEAR(shift(0.05, 0.80), 1.960 + 0.842, 0.001);
  EXPECT_NEAR(shift(0.05, 0.90), 1.960 + 1.282, 0.001);
  EXPECT_NEAR(shift(0.001, 0.90), 3.291 + 1.282, 0.001);
}

TEST(ReadingTest, CountsBothCirclesOfASingleRowOnce) {
  EXPECT_EQ(differentTests(fitSession(test::paperMeasurement()).joint.readings), 34);
  // Two faces and the slider: five readings of each of the 34 visits, all of them different tests.
  const Measurement full = test::trialMeasurement("full");
  std::size_t readings = 0;
  for (const AdjustedReading& reading : fitSession(full).joint.readings) readings += reading.isChecked();
  EXPECT_EQ(differentTests(fitSession(full).joint.readings), static_cast<int>(readings));
}

// The general fit and the fast one number visits identically.
TEST(ReadingTest, CountsTheSameInEitherFit) {
  const Measurement measurement = test::paperMeasurement();
  std::vector<Circle> starts;
  for (const ArcFit& arc : fitSession(measurement).arcs) starts.push_back(arc.circle);
  EXPECT_EQ(differentTests(fitJointlyInGeneral(measurement, starts, {}).readings), 34);
}

}  // namespace
}  // namespace alidade
