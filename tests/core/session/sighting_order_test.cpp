#include "core/session/sighting_order.h"

#include <gtest/gtest.h>

namespace alidade {
namespace {

Reading row(int point, int round = 1, int face = 1) {
  Reading reading;
  reading.point = std::to_string(point);
  reading.round = std::to_string(round);
  reading.face = std::to_string(face);
  reading.horizontal = "1 2 3";
  return reading;
}

std::string shortText(const Reading& reading) {
  return reading.point + "/" + (reading.round.empty() ? "1" : reading.round) + "/" +
         (reading.face.empty() ? "1" : reading.face);
}

std::string shortText(const std::vector<Reading>& rows) {
  std::string text;
  for (const Reading& reading : rows) text += shortText(reading) + " ";
  return text;
}

std::string after(std::vector<Reading> rows, std::vector<Reading> other = {}) {
  Session session = blankSession();
  session.positions[0].readings = std::move(other);
  session.positions[1].readings = std::move(rows);
  return shortText(followingReading(session, 1));
}

TEST(FollowingReading, CountsOnInTheDirectionOfTheLastTwo) {
  EXPECT_EQ(after({}), "1/1/1");
  EXPECT_EQ(after({row(1)}), "2/1/1");
  EXPECT_EQ(after({row(5), row(6)}), "7/1/1");
  EXPECT_EQ(after({row(9), row(8)}), "7/1/1");
  EXPECT_EQ(after({row(3, 2, 2)}), "4/2/2") << "round and face stay";
}

TEST(FollowingReading, GoesBackAsItCame) {
  const std::vector<Reading> there{row(1), row(2), row(4), row(7)};
  std::vector<Reading> rows = there;
  std::string order;
  rows.push_back(row(7, 2));
  for (int i = 0; i < 3; ++i) {
    Session session = blankSession();
    session.positions[0].readings = rows;
    rows.push_back(followingReading(session, 0));
    order += shortText(rows.back()) + " ";
  }
  EXPECT_EQ(order, "4/2/1 2/2/1 1/2/1 ");
}

TEST(FollowingReading, BeginsANewRoundWhereAWayBackEnds) {
  EXPECT_EQ(after({row(2), row(1)}), "1/2/1") << "there is no point 0 to go back to";
  const std::vector<Reading> thereAndBack{row(1), row(2), row(3), row(3, 2), row(2, 2), row(1, 2)};
  EXPECT_EQ(after(thereAndBack), "1/3/1") << "point 2 of round 2 is taken";
  std::vector<Reading> begun = thereAndBack;
  begun.push_back(row(1, 3));
  EXPECT_EQ(after(begun), "2/3/1");
  const std::vector<Reading> inPairs{row(2), row(2, 1, 2), row(1), row(1, 1, 2)};
  EXPECT_EQ(after(inPairs), "1/2/1") << "both faces at each place";
}

TEST(FollowingReading, RepeatsARoundInItsOrder) {
  EXPECT_EQ(after({row(1), row(4), row(9), row(1, 2), row(4, 2)}), "9/2/1");
}

TEST(FollowingReading, IsThatOfAPositionReadBefore) {
  const std::vector<Reading> first{row(3), row(3, 1, 2), row(5), row(5, 1, 2), row(5, 2)};
  EXPECT_EQ(after({}, first), "3/1/1");
  EXPECT_EQ(after({row(3)}, first), "3/1/2");
  EXPECT_EQ(after({row(3), row(3, 1, 2), row(5), row(5, 1, 2)}, first), "5/2/1");
  EXPECT_EQ(after({row(4)}, first), "5/1/1") << "another order than that one's";
  EXPECT_EQ(after(first, first), "5/2/2") << "longer than that one: each place in both faces";
}

TEST(FollowingReading, GoesOnInBothFacesOfEachPlace) {
  EXPECT_EQ(after({row(1), row(1, 1, 2)}), "2/1/1");
  EXPECT_EQ(after({row(1), row(1, 1, 2), row(2)}), "2/1/2");
  EXPECT_EQ(after({row(1), row(1, 1, 2), row(2), row(2, 1, 2)}), "3/1/1");
  EXPECT_EQ(after({row(1), row(1, 1, 2), row(2, 1, 2), row(2)}), "3/1/1") << "1 2 2 1";
  EXPECT_EQ(after({row(1), row(1, 1, 2), row(2, 1, 2), row(2), row(3)}), "3/1/2");
  EXPECT_EQ(after({row(9), row(9, 1, 2), row(8), row(8, 1, 2)}), "7/1/1") << "on the way back";
}

/// An empty round or face is round 1, face 1.
TEST(FollowingReading, TakesAnEmptyEntryForItsDefault) {
  std::vector<Reading> rows{row(1), row(2)};
  for (Reading& reading : rows) reading.round = reading.face = "";
  EXPECT_EQ(after(rows, {row(1), row(2), row(6)}), "6/1/1");
}

TEST(FurtherRows, LieOutTheWayBackAndTheOtherFace) {
  const std::vector<Reading> rows{row(1), row(2), row(3)};
  EXPECT_EQ(shortText(furtherRows(rows, FurtherRows::WayBack)), "3/2/1 2/2/1 1/2/1 ");
  EXPECT_EQ(shortText(furtherRows(rows, FurtherRows::WayBackInTwo)), "3/2/2 2/2/2 1/2/2 ");
  EXPECT_EQ(shortText(furtherRows(rows, FurtherRows::AnotherRound)), "1/2/1 2/2/1 3/2/1 ");
}

TEST(FurtherRows, AreOfTheLastStretchAlone) {
  const std::vector<Reading> rows{row(1), row(2), row(2, 2, 2), row(1, 2, 2)};
  EXPECT_EQ(shortText(furtherRows(rows, FurtherRows::WayBack)), "1/3/2 2/3/2 ");
}

TEST(FurtherRows, AreNoneWhereThereIsNothingToRepeat) {
  EXPECT_TRUE(furtherRows({}, FurtherRows::WayBack).empty());
}

}  // namespace
}  // namespace alidade
