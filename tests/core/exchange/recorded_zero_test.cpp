#include "core/exchange/recorded_zero.h"

#include <gtest/gtest.h>

#include <deque>

namespace alidade::test {
namespace {

/// Sightings of one zero, in the order added.
class Zero {
 public:
  Zero& add(const char* horizontal, const char* vertical, int face = 1, bool isAfter = false) {
    Reading& row = m_recorded.emplace_back().row;
    row.horizontal = horizontal;
    row.vertical = vertical;
    row.face = face == 2 ? "2" : "";
    m_sightings.push_back({&m_recorded.back(), isAfter});
    return *this;
  }

  RecordedZero recorded(VerticalCircle circle = VerticalCircle::Zenith) const {
    return recordedZero(m_sightings, circle);
  }

 private:
  std::deque<RecordedSighting> m_recorded;
  std::vector<ZeroInFile> m_sightings;
};

// 359°59'58" and 0°00'04" have the mean 0°00'01" on either circle; no circle reads 360°.
TEST(RecordedZero, HasMeansOnTheCircle) {
  const PointingZero low = Zero()
                               .add("359°59'58\"", "359°59'58\"")
                               .add("0°00'04\"", "0°00'04\"")
                               .recorded(VerticalCircle::Elevation)
                               .zero;
  EXPECT_EQ(low.horizontal, "0°00'01.00\"");
  EXPECT_EQ(low.vertical, "0°00'01.00\"");
  const PointingZero high = Zero()
                                .add("359°59'59.99\"", "0°00'00\"")
                                .add("0°00'00.008\"", "359°59'59\"")
                                .recorded(VerticalCircle::Elevation)
                                .zero;
  EXPECT_EQ(high.horizontal, "0°00'00.00\"");
  EXPECT_EQ(high.vertical, "-0°00'00.50\"");
}

TEST(RecordedZero, HasEachSightingInItsPlace) {
  const RecordedZero recorded = Zero()
                                    .add("10°", "90°")
                                    .add("190°", "270°", 2)
                                    .add("190°00'04\"", "270°00'02\"", 2)
                                    .add("190°00'10\"", "270°00'10\"", 2, true)
                                    .add("10°00'10\"", "90°00'10\"", 1, true)
                                    .recorded();
  EXPECT_EQ(recorded.zero.horizontal, "10°");
  EXPECT_EQ(recorded.zero.faceTwo.horizontal, "190°00'02.00\"") << "as read in face 2";
  EXPECT_EQ(recorded.zero.faceTwo.vertical, "270°00'01.00\"");
  EXPECT_EQ(recorded.zero.after.vertical, "90°00'10\"");
  EXPECT_EQ(recorded.zero.afterInTwo.horizontal, "190°00'10\"");
  ASSERT_EQ(recorded.means.size(), 1U);
  EXPECT_EQ(recorded.means[0].face, 2);
  EXPECT_FALSE(recorded.means[0].isAfter || recorded.isConverted || recorded.apart);
}

TEST(RecordedZero, BeginsInFaceOneEvenIfThatCameLast) {
  const PointingZero zero =
      Zero().add("190°00'02\"", "270°", 2).add("10°00'10\"", "90°", 1, true).recorded().zero;
  EXPECT_EQ(zero.horizontal, "10°00'10\"");
  EXPECT_EQ(zero.faceTwo.horizontal, "190°00'02\"");
  EXPECT_EQ(zero.after, ZeroSighting());
}

TEST(RecordedZero, IsConvertedIfFaceTwoIsAllThereIs) {
  const RecordedZero recorded =
      Zero().add("190°00'02\"", "270°00'10\"", 2).add("190°00'20\"", "270°", 2, true).recorded();
  EXPECT_TRUE(recorded.isConverted);
  EXPECT_EQ(recorded.zero.horizontal, "10°00'02.00\"");
  EXPECT_EQ(recorded.zero.vertical, "89°59'50.00\"");
  EXPECT_EQ(recorded.zero.after.horizontal, "10°00'20.00\"");
  EXPECT_EQ(recorded.zero.faceTwo, ZeroSighting());
}

TEST(RecordedZero, NamesTheSightingThatIsNoneOfIt) {
  const auto apart = Zero().add("10°", "90°").add("190°", "268°", 2).add("14°", "90°").recorded().apart;
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->sighting->row.vertical, "268°");
  EXPECT_TRUE(apart->isVertical);
  EXPECT_NEAR(apart->degrees, 2, 1e-9);
}

}  // namespace
}  // namespace alidade::test
