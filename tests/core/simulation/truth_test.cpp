#include "core/simulation/truth.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

TEST(Truth, IsDrawnFromItsSeed) {
  const Truth one = drawTruth(1), again = drawTruth(1), other = drawTruth(2);
  EXPECT_EQ(one.intersection, again.intersection);
  EXPECT_NE(one.intersection, other.intersection);
  EXPECT_LT(std::abs(one.intersection), 3);
  EXPECT_TRUE(one.effects.empty());
}

TEST(Truth, TurnsCatalogueUnitsIntoTheModels) {
  Truth truth;
  truth.effects = {{ErrorTerm::Collimation, 20}, {ErrorTerm::PlaneTiltX, 0.5}, {ErrorTerm::GravitySag, 0.1}};
  const ErrorTerms<double> errors = errorsOf(truth);
  EXPECT_DOUBLE_EQ(errors[ErrorTerm::Collimation], Angle::fromArcseconds(20).radians());
  EXPECT_DOUBLE_EQ(errors[ErrorTerm::PlaneTiltX], Angle::fromDegrees(0.5).radians());
  EXPECT_DOUBLE_EQ(errors[ErrorTerm::GravitySag], 0.1);
  EXPECT_EQ(errors[ErrorTerm::TrunnionTilt], 0);
}

}  // namespace
}  // namespace alidade
