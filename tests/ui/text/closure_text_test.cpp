#include "ui/text/closure_text.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

TEST(ClosureText, StatesUAtTheCoverageAndTheSizeInSigma) {
  const Closure closure{.of = Closure::Of::Radius, .value = 1.96, .sigma = 0.28};
  EXPECT_EQ(closureText(closure, 0.95), QStringLiteral("1.96 ± 0.55 mm"));
  EXPECT_EQ(closureText(closure, 0.6827), QStringLiteral("1.96 ± 0.28 mm"));
  EXPECT_EQ(closureSigmasText(closure), QStringLiteral("7.0 σ"));
}

TEST(ClosureText, WritesTheSizeOfAnEffectWithItsUnit) {
  EXPECT_EQ(requiredSizeText({.effect = "plane_offset", .size = -5.84, .unit = "mm"}),
            QStringLiteral("−5.8 mm"));
  EXPECT_EQ(requiredSizeText({.effect = "trunnion_tilt", .size = 123.4, .unit = "arcsec"}),
            QStringLiteral("123″"));
  EXPECT_EQ(requiredSizeText({.effect = "scale", .size = 0.00123, .unit = "1"}), QStringLiteral("0.0012"));
}

TEST(ClosureText, NeverCallsAPlausibleSizeNothing) {
  EXPECT_EQ(plausibleSizesText({.effect = "plane_tilt", .unit = "deg", .plausibleSizes = 2.44}),
            QStringLiteral("2.4"));
  EXPECT_EQ(plausibleSizesText({.effect = "plane_tilt", .unit = "deg", .plausibleSizes = 0.1}),
            QStringLiteral("0.1"));
  EXPECT_EQ(plausibleSizesText({.effect = "plane_tilt", .unit = "deg", .plausibleSizes = 0.03}),
            QStringLiteral("< 0.1"));
}

}  // namespace
}  // namespace alidade::ui
