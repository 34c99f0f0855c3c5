#include "core/session/entry_to_come.h"

#include <gtest/gtest.h>

#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

void expectZero(const Session& session, std::size_t here, std::size_t position) {
  const auto next = entryToComeOf(session, here);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->position, position);
  EXPECT_EQ(next->zero, "pointing_zero");
}

void expectRow(const Session& session, std::size_t here, std::size_t position, std::size_t row) {
  const auto next = entryToComeOf(session, here);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->position, position);
  EXPECT_EQ(next->zero, "");
  EXPECT_EQ(next->row, row);
}

TEST(EntryToCome, IsTheZeroOfAnEmptySession) {
  Session session = paperSession();
  for (Position& position : session.positions) position.readings.clear(), position.zero = {};
  expectZero(session, 0, 0);
  expectZero(session, 1, 1);
}

TEST(EntryToLeadTo, IsDistanceAndRadiusBeforeAllElse) {
  Session session = paperSession();
  session.geometry.radiusMm.clear();
  EXPECT_EQ(entryToLeadTo(session, 0)->field, "geometry.radius_mm");
  session.geometry.distanceMm.clear();
  EXPECT_EQ(entryToLeadTo(session, 1)->field, "geometry.distance_mm");
}

TEST(EntryToLeadTo, IsAMissingZeroRatherThanAFurtherRow) {
  Session session = paperSession();
  session.positions[1] = {.axisDeg = "180", .zero = {}, .readings = {}, .origin = {}};
  const auto next = entryToLeadTo(session, 0);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->position, 1u);
  EXPECT_EQ(next->zero, "pointing_zero");
  EXPECT_EQ(entryToCome(session, 0)->row, 17u) << "a reading over the cable stays where the axis is";
}

TEST(EntryToCome, IsAReadingOnceThereAreZeros) {
  Session session = paperSession();
  for (Position& position : session.positions) position.readings.clear();
  expectRow(session, 0, 0, 0);
  expectRow(session, 1, 1, 0);
}

TEST(EntryToCome, IsTheMissingZeroOfAPositionThatWasBegun) {
  for (const std::size_t lacking : {0U, 1U})
    for (const std::size_t here : {0U, 1U}) {
      Session session = paperSession();
      session.positions[lacking].zero.horizontal.clear();
      expectZero(session, here, lacking);
      session.positions[lacking].zero = {};
      expectZero(session, here, lacking);
      session.positions[lacking].readings.resize(4);
      expectZero(session, here, lacking);
    }
}

TEST(EntryToCome, IsTheZeroOfAThirdPositionOnceTheOthersAreComplete) {
  Session session = paperSession();
  session.positions.push_back({.axisDeg = "0", .zero = {}, .readings = {}, .origin = {}});
  for (const std::size_t here : {0U, 1U, 2U}) expectZero(session, here, 2);
}

TEST(EntryToCome, IsTheHalfFilledRowBeforeAMissingZero) {
  Session session = paperSession();
  session.positions[1].zero = {};
  session.positions[0].readings[3].vertical.clear();
  for (const std::size_t here : {0U, 1U}) expectRow(session, here, 0, 3);
  session.positions[0].readings[3].excluded = true;
  expectZero(session, 0, 1);
}

TEST(EntryToCome, IsNothingWhereAllIsThere) {
  EXPECT_FALSE(entryToComeOf(paperSession(), 0));
}

}  // namespace
}  // namespace alidade::test
