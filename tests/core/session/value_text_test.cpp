#include "core/session/value_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/angle_text.h"

namespace alidade {
namespace {

using Json = nlohmann::ordered_json;

TEST(ValueText, KeepsNumbersAsTheirShortestText) {
  EXPECT_EQ(textOf(Json(2405), ValueKind::Number), "2405");
  EXPECT_EQ(textOf(Json(2405.0), ValueKind::Number), "2405");
  EXPECT_EQ(textOf(Json(0.1), ValueKind::Number), "0.1");
  EXPECT_EQ(textOf(Json(18446744073709551615ull), ValueKind::Number), "18446744073709551615");
  EXPECT_EQ(textOf(Json("2405 mm"), ValueKind::Number), "2405 mm");
}

TEST(ValueText, ReadsAngleNumbersAsMarkedDecimalDegrees) {
  EXPECT_EQ(textOf(Json(341.873333), ValueKind::Angle), "341.873333°");
  EXPECT_EQ(textOf(Json(341), ValueKind::Angle), "341°");
  EXPECT_EQ(textOf(Json("341 52 24"), ValueKind::Angle), "341 52 24");
  for (const double tiny : {1e-7, 5e-324, 1.7976931348623157e308}) {
    const auto angle = parseAngle(*textOf(Json(tiny), ValueKind::Angle));
    ASSERT_TRUE(angle) << tiny;
    EXPECT_EQ(*angle, Angle::fromDegrees(tiny));
  }
}

TEST(ValueText, RefusesOtherJsonTypes) {
  EXPECT_FALSE(textOf(Json(), ValueKind::Number));
  EXPECT_FALSE(textOf(Json(true), ValueKind::Angle));
  EXPECT_FALSE(textOf(Json::array(), ValueKind::Text));
  EXPECT_FALSE(textOf(Json(5), ValueKind::Text));
}

TEST(ValueText, WritesNumbersAsNumbersAndTheRestAsTyped) {
  EXPECT_EQ(valueOf("2405", ValueKind::Number).dump(), "2405");
  EXPECT_EQ(valueOf("2405,5", ValueKind::Number).dump(), "2405.5");
  EXPECT_EQ(valueOf("1e3", ValueKind::Number).dump(), "1000");
  EXPECT_EQ(valueOf("2405 mm", ValueKind::Number).dump(), "\"2405 mm\"");
  EXPECT_EQ(valueOf("341.5°", ValueKind::Angle).dump(), "\"341.5°\"");
  EXPECT_EQ(valueOf("17", ValueKind::Text).dump(), "\"17\"");
}

}  // namespace
}  // namespace alidade
