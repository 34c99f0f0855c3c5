#include "ui/text/effect_text.h"

#include <gtest/gtest.h>

namespace alidade::ui {
namespace {

TEST(EffectText, NamesTheNumberOnlyWhereTheEffectDoesNot) {
  EXPECT_EQ(effectText({"trunnion_tilt", "tilt", "arcsec"}), QStringLiteral("trunnion tilt"));
  EXPECT_EQ(effectText({"plane_tilt", "tilt about x", "deg"}), QStringLiteral("plane tilt, tilt about x"));
  EXPECT_EQ(effectText({"arc_lobing", "sine", "mm"}), QStringLiteral("arc lobing, sine"));
}

TEST(EffectText, WritesUnitsAsSigns) {
  EXPECT_EQ(effectUnitText({"a", "b", "arcsec"}), QStringLiteral("″"));
  EXPECT_EQ(effectUnitText({"a", "b", "deg"}), QStringLiteral("°"));
  EXPECT_EQ(effectUnitText({"a", "b", "mm"}), QStringLiteral("mm"));
  EXPECT_EQ(effectUnitText({"a", "b", "1"}), QString());
  EXPECT_EQ(effectUnitText({"a", "b", "-"}), QString());
}

}  // namespace
}  // namespace alidade::ui
