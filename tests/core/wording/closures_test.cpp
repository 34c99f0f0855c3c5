#include "core/wording/closures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

constexpr Closure failing{Closure::Of::Radius, 1.96, 0.28, 1e-9}, sound{Closure::Of::Centre, 0.05, 0.09, 0.6};

TEST(ClosuresInWords, StateMisclosureUncertaintyAndSigmas) {
  EXPECT_EQ(textOf(failing), "R(180°) − R(0°) = 1.96 mm (u 0.28), 7.0 σ");
  EXPECT_EQ(textOf(sound), "Δx(180°) − Δx(0°) = 0.050 mm (u 0.090), 0.6 σ");
}

TEST(ClosuresInWords, NameThePositionMeasuredAgain) {
  Closure repeat{Closure::Of::Repeat, -0.123, 0.034, 1e-4};
  repeat.repeated = {0, 2, Unknown::Kind::CentreX};
  EXPECT_EQ(textOf(repeat), "Δx(0° again) − Δx(0°) = −0.123 mm (u 0.034), 3.6 σ");
  repeat.repeated = {180, 3, Unknown::Kind::CentreY};
  EXPECT_EQ(nameInWords(repeat), "Δy(180° again (3)) − Δy(180°)");
  repeat.repeated = {180, 2, Unknown::Kind::Radius};
  EXPECT_EQ(nameInWords(repeat), "R(180° again) − R(180°)");
  Diagnosis diagnosis;
  diagnosis.closures = {{repeat}};
  EXPECT_THAT(misclosureSentence(diagnosis),
              ::testing::StartsWith("The positions do not agree: R(180° again) − R(180°)"));
}

TEST(ClosuresInWords, NameWhatFailsWithTheCausesInTheModel) {
  Diagnosis diagnosis;
  EXPECT_EQ(misclosureSentence(diagnosis), "");
  diagnosis.closures = {{failing, sound}, {sound}};
  EXPECT_EQ(misclosureSentence(diagnosis), "") << "the causes account for it";
  diagnosis.closures = {{failing}, {sound}};
  EXPECT_THAT(misclosureSentence(diagnosis), ::testing::StartsWith("The positions do not agree: R(180°)"));
  EXPECT_THAT(misclosureSentence(diagnosis), ::testing::Not(::testing::HasSubstr("Δx")));
  diagnosis.closures = {{sound, failing}};
  EXPECT_NE(misclosureSentence(diagnosis), "") << "the causes open it";
}

}  // namespace
}  // namespace alidade
