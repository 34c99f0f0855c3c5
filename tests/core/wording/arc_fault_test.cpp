#include "core/wording/findings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alidade {
namespace {

using namespace arc_fault;
using testing::HasSubstr, testing::Not, testing::StartsWith;

TEST(ArcFaultInWords, CountsPlaces) {
  EXPECT_THAT(textOf(TooFewPlaces{0}), StartsWith("has no readings yet"));
  EXPECT_THAT(textOf(TooFewPlaces{1}), StartsWith("has readings of 1 place;"));
  EXPECT_THAT(textOf(PlacesRepeat{1}), HasSubstr("only 1 distinct place,"));
  EXPECT_THAT(textOf(PlacesRepeat{2}), HasSubstr("only 2 distinct places,"));
  EXPECT_THAT(textOf(TooFewForPublished{4}), HasSubstr("4 places; the published method needs five"));
}

TEST(ArcFaultInWords, BlamesTheArcOrTheReadings) {
  EXPECT_THAT(textOf(ArcTooShort{Angle::fromDegrees(1.5)}), StartsWith("spans only 1.50° of arc"));
  EXPECT_THAT(textOf(RadiusUndetermined{}), HasSubstr("misread"));
  EXPECT_THAT(textOf(PlacesOnALine{}), HasSubstr("straight line"));
}

// The text continues "The arc at 0° …."
TEST(ArcFaultInWords, IsTheEndOfASentenceWithoutItsStop) {
  for (const ArcFault& fault :
       {ArcFault(TooFewPlaces{}), ArcFault(PlacesRepeat{}), ArcFault(PlacesOnALine{}),
        ArcFault(ArcTooShort{}), ArcFault(RadiusUndetermined{}), ArcFault(TooFewForPublished{}),
        ArcFault(NoUniqueSolution{}), ArcFault(NoPublishedCircle{})}) {
    EXPECT_THAT(textOf(fault), testing::AnyOf(StartsWith("has "), StartsWith("spans ")));
    EXPECT_THAT(textOf(fault), Not(testing::EndsWith(".")));
  }
}

}  // namespace
}  // namespace alidade
