#include "ui/text/quantity_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace alidade::ui {
namespace {

TEST(QuantityText, WritesARealMinusAndNeverAMinusZero) {
  EXPECT_EQ(numberText(-0.835634, 3), QStringLiteral("−0.836"));
  EXPECT_EQ(numberText(-0.0001, 3), QStringLiteral("0.000"));
  EXPECT_EQ(signedNumberText(1.25, 1), QStringLiteral("+1.2"));
  EXPECT_EQ(signedNumberText(-1.26, 1), QStringLiteral("−1.3"));
  EXPECT_EQ(signedNumberText(0.0001, 1), QStringLiteral("0.0"));
}

TEST(QuantityText, ShowsADashWhereThereIsNoNumber) {
  EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN(), 3), notStated());
  EXPECT_EQ(plainNumberText(std::numeric_limits<double>::infinity()), notStated());
  EXPECT_EQ(orNotStated(QStringLiteral("  ")), QStringLiteral("—"));
  EXPECT_EQ(orNotStated(QStringLiteral("Meyer")), QStringLiteral("Meyer"));
}

TEST(QuantityText, HidesWhatConversionsDoToTypedNumbers) {
  EXPECT_EQ(plainNumberText(Angle::fromArcseconds(5).arcseconds()), QStringLiteral("5"));
  EXPECT_EQ(plainNumberText(0.1 + 0.2), QStringLiteral("0.3"));
  EXPECT_EQ(plainNumberText(-2405.25), QStringLiteral("−2405.25"));
}

TEST(QuantityText, PutsUnitsWhereTheyBelong) {
  EXPECT_EQ(lengthText(401.954264), QStringLiteral("401.9543 mm"));
  EXPECT_EQ(arcsecText(-9.375), QStringLiteral("−9.4″"));
  EXPECT_EQ(angleText(Angle::fromDegrees(341.873333333)), QStringLiteral("341°52′24″"));
  EXPECT_EQ(plainNumberText(2405), QStringLiteral("2405"));
  EXPECT_EQ(exaggerationText(500), QStringLiteral("× 500"));
}

}  // namespace
}  // namespace alidade::ui
