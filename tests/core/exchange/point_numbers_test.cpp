#include "core/exchange/point_numbers.h"

#include <gmock/gmock.h>

namespace alidade::test {
namespace {

using ::testing::Pair;
using ::testing::UnorderedElementsAre;

TEST(PointNumbers, KeepsNumbers) {
  EXPECT_THAT(pointNumbers({"7", "5", "7", ""}), UnorderedElementsAre(Pair("7", "7"), Pair("5", "5")));
}

TEST(PointNumbers, TakesTheNumberANameEndsWith) {
  EXPECT_THAT(pointNumbers({"P07", "P08", "3"}),
              UnorderedElementsAre(Pair("P07", "7"), Pair("P08", "8"), Pair("3", "3")));
}

TEST(PointNumbers, CountsNamesThatWouldBeMixedUp) {
  EXPECT_THAT(pointNumbers({"A1", "B1"}), UnorderedElementsAre(Pair("A1", "1"), Pair("B1", "2")));
  EXPECT_THAT(pointNumbers({"left", "top"}), UnorderedElementsAre(Pair("left", "1"), Pair("top", "2")));
  EXPECT_THAT(pointNumbers({"1000000000000001"}), UnorderedElementsAre(Pair("1000000000000001", "1")));
}

}  // namespace
}  // namespace alidade::test
