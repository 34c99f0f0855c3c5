#include "core/wording/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace setup_finding;
using testing::HasSubstr, testing::StartsWith;

TEST(SetupFindingsInWords, NameTheLengthsAsTyped) {
  const Words words = wordsOf(DistanceTooShort{2.405, 0.4});
  EXPECT_EQ(words.text, "No theodolite sights anything at a distance of 2.405 mm.");
  EXPECT_THAT(words.remedy, HasSubstr("the distance L (2.405)"));
  EXPECT_THAT(words.remedy, HasSubstr("the nominal radius R0 (0.4)"));
}

TEST(SetupFindingsInWords, TellOneArcFromBoth) {
  const Words one = wordsOf(PlacesOnTheWrongSide{{180}}), both = wordsOf(PlacesOnTheWrongSide{{0, 180}});
  EXPECT_THAT(
      one.text,
      HasSubstr("Most places lie on the wrong side of the fitted centre, at 180° above it: they should"));
  EXPECT_THAT(one.remedy, HasSubstr("the axis of this position"));
  EXPECT_THAT(both.text, HasSubstr("Most places lie on the wrong side of the fitted centre, at 0° below it "
                                   "and at 180° above it: they should"));
  EXPECT_THAT(both.remedy, HasSubstr("whether the positions are exchanged"));
}

TEST(SetupFindingsInWords, NameTheOtherKindOfCircle) {
  const Words zenith = wordsOf(ZeroOfOtherCircle{0, Angle::fromDegrees(0.001), VerticalCircle::Zenith});
  EXPECT_THAT(zenith.text, HasSubstr("at 0° has 0.00° on the vertical circle, far from the horizon of a "
                                     "zenith circle, which reads 90° there"));
  EXPECT_THAT(zenith.remedy, HasSubstr("on an elevation circle"));
  const Words elevation = wordsOf(ZeroOfOtherCircle{0, Angle::fromDegrees(90), VerticalCircle::Elevation});
  EXPECT_THAT(elevation.text, HasSubstr("an elevation circle, which reads 0° there"));
  EXPECT_THAT(elevation.remedy, HasSubstr("on a zenith circle"));
}

TEST(SetupFindingsInWords, CountTheOtherSliderValues) {
  SlidersDiffer differ{.axisDeg = 180, .firstRow = 4, .otherRow = 5, .apart = Angle::fromDegrees(1)};
  EXPECT_EQ(wordsOf(differ).text,
            "180°: rows 5 and 6 are of one visit, yet their slider values differ by 3600.0″; only the first "
            "is used.");
  differ.others = 2;
  EXPECT_THAT(wordsOf(differ).text, HasSubstr("only the first is used, here and in 2 more cases."));
}

TEST(SetupFindingsInWords, AskWhetherZerosThatAreAlikeAreOne) {
  EXPECT_THAT(wordsOf(ZerosAlike{}).text, StartsWith("Both positions have the same pointing zero"));
  EXPECT_THAT(wordsOf(ZerosAlike{3}).text, StartsWith("All positions have the same pointing zero"));
}

TEST(SetupFindingsInWords, SayHowFarAZeroMoved) {
  ZeroMoved moved{.axisDeg = 180,
                  .horizontal = Angle::fromArcseconds(-1),
                  .vertical = Angle::fromArcseconds(12.34),
                  .sigmaHorizontal = Angle::fromArcseconds(2.8),
                  .sigmaVertical = Angle::fromArcseconds(2.8)};
  EXPECT_EQ(
      wordsOf(moved).text,
      "180°: the pointing zero moved by −1.0″ ± 2.8″ horizontally and 12.3″ ± 2.8″ vertically (1σ) while the "
      "position was read.");
  moved.scatter = 3.14;
  EXPECT_THAT(wordsOf(moved).text, HasSubstr("; U assumes that the zeros scatter 3.1 times their stated σ."));
}

TEST(SetupFindingsInWords, NameThePositionWhoseFaceTwoIsLeftOut) {
  EXPECT_THAT(wordsOf(ZeroFaceLeftOut{.axisDeg = 0, .repeat = 2}).text,
              StartsWith("0° again: the sightings of the pointing zero in face 2 are left out"));
}

}  // namespace
}  // namespace alidade
