#include "core/exchange/zero_means.h"

#include <gtest/gtest.h>

namespace alidade::test {
namespace {

ZeroMean meanOf(const std::string& horizontal, const std::string& vertical,
                const std::string& otherHorizontal, const std::string& otherVertical, VerticalCircle circle) {
  RecordedSighting one, other;
  one.row.horizontal = horizontal;
  one.row.vertical = vertical;
  other.row.horizontal = otherHorizontal;
  other.row.vertical = otherVertical;
  return zeroMean({&one, &other}, circle);
}

// 359°59'58" and 0°00'04" have the mean 0°00'01" on either circle; no circle reads 360°.
TEST(ZeroMean, IsOnTheCircle) {
  const ZeroMean low =
      meanOf("359°59'58\"", "359°59'58\"", "0°00'04\"", "0°00'04\"", VerticalCircle::Elevation);
  EXPECT_EQ(low.horizontal, "0°00'01.00\"");
  EXPECT_EQ(low.vertical, "0°00'01.00\"");
  const ZeroMean high =
      meanOf("359°59'59.99\"", "0°00'00\"", "0°00'00.008\"", "359°59'59\"", VerticalCircle::Elevation);
  EXPECT_EQ(high.horizontal, "0°00'00.00\"");
  EXPECT_EQ(high.vertical, "-0°00'00.50\"");
}

}  // namespace
}  // namespace alidade::test
