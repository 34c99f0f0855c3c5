#include "core/observation/reading_ref.h"

#include <gtest/gtest.h>

#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

TEST(ReadingRef, KindsAreNamedAsInFiles) {
  EXPECT_EQ(nameOf(ReadingKind::Horizontal), "horizontal");
  EXPECT_EQ(nameOf(ReadingKind::Vertical), "vertical");
  EXPECT_EQ(nameOf(ReadingKind::Slider), "slider");
}

TEST(ReadingRef, KindsAreCalledSoByPeopleToo) {
  for (const auto kind : {ReadingKind::Horizontal, ReadingKind::Vertical, ReadingKind::Slider})
    EXPECT_EQ(inWords(kind), nameOf(kind));
}

TEST(ReadingRef, SigmaIsThatOfTheKind) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaHorizontal = Angle::fromArcseconds(1);
  measurement.sigmaVertical = Angle::fromArcseconds(2);
  measurement.sigmaSlider = Angle::fromArcseconds(3);
  EXPECT_EQ(statedSigma(measurement, ReadingKind::Horizontal), measurement.sigmaHorizontal);
  EXPECT_EQ(statedSigma(measurement, ReadingKind::Vertical), measurement.sigmaVertical);
  EXPECT_EQ(statedSigma(measurement, ReadingKind::Slider), measurement.sigmaSlider);
}

// e = β0 − β on a zenith circle, β − β0 on an elevation circle; in face 2 the vertical circle runs backwards.
TEST(ReadingRef, VerticalCirclesRunEitherWay) {
  Measurement measurement = test::usualMeasurement();
  for (const auto& [circle, inFaceOne] :
       {std::pair(VerticalCircle::Zenith, -1), {VerticalCircle::Elevation, 1}}) {
    measurement.verticalCircle = circle;
    EXPECT_EQ(sideOf(measurement, 1, ReadingKind::Vertical), inFaceOne);
    EXPECT_EQ(sideOf(measurement, 2, ReadingKind::Vertical), -inFaceOne);
    for (const int face : {1, 2}) {
      EXPECT_EQ(sideOf(measurement, face, ReadingKind::Horizontal), 1);
      EXPECT_EQ(sideOf(measurement, face, ReadingKind::Slider), 1);
    }
  }
}

}  // namespace
}  // namespace alidade
