#include "core/adjustment/arc/arc_checks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using namespace arc_fault;

TEST(ArcChecks, CountPlacesThatDifferByMoreThanTheNoise) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaHorizontal = measurement.sigmaVertical = Angle::fromArcseconds(1);
  const double noise = 5 * measurement.distance * Angle::fromArcseconds(1).radians();
  const auto check = [&](const std::vector<PlanePoint<double>>& places) {
    return tooFewPlaces(measurement, places);
  };
  EXPECT_EQ(std::get<TooFewPlaces>(check({{0, 0}, {9, 9}}).value()).places, 2u);
  EXPECT_EQ(std::get<PlacesRepeat>(check({{0, 0}, {0, 0}, {0, 0.9 * noise}}).value()).different, 1u);
  EXPECT_EQ(std::get<PlacesRepeat>(check({{0, 0}, {9, 9}, {0, 0.9 * noise}}).value()).different, 2u);
  EXPECT_FALSE(check({{0, 0}, {9, 9}, {0, 1.1 * noise}}));
}

// A short arc has a small sagitta. A wide arc, or one without finite numbers, fails for other reasons.
TEST(ArcChecks, BlameTheShortArcOnlyWhereItIsShort) {
  ArcFit fit;
  fit.circle.radius = 400;
  fit.cofactor[2][2] = 100 * 100;
  EXPECT_FALSE(radiusUndetermined(fit)) << "a quarter of the radius";
  fit.cofactor[2][2] = 200 * 200;
  const auto spanning = [&](double radians) {
    fit.residuals.assign(3, {});
    for (std::size_t i = 0; i < 3; ++i) fit.residuals[i].arcAngle = radians / 2 * static_cast<double>(i);
    return radiusUndetermined(fit).value();
  };
  EXPECT_NEAR(std::get<ArcTooShort>(spanning(0.1)).span.radians(), 0.1, 1e-12);
  EXPECT_TRUE(std::holds_alternative<RadiusUndetermined>(spanning(3)));
  EXPECT_TRUE(std::holds_alternative<RadiusUndetermined>(spanning(NAN)));
}

// The unsighted part of the circle is the widest gap, wherever φ = ±180° is.
TEST(ArcChecks, SpanIsWhatTheWidestGapLeaves) {
  const Measurement measurement = test::usualMeasurement();
  for (const double middle : {90.0, 180.0, 270.0}) {
    const ArcFit fit =
        *fitArc(measurement, test::perfectArc(measurement, {0, 0, 400}, test::spread(9, 160, middle)));
    EXPECT_NEAR(arcSpan(fit).degrees(), 160, 1e-6) << middle;
  }
}

}  // namespace
}  // namespace alidade
