#include "core/session/row_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/session/measurement.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

using Sequences = std::vector<std::size_t>;

Session withAxes(const std::vector<std::pair<std::string, std::size_t>>& positions) {
  Session session;
  for (const auto& [axis, rows] : positions) {
    session.positions.emplace_back();
    session.positions.back().axisDeg = axis;
    session.positions.back().readings.resize(rows);
  }
  return session;
}

TEST(FirstSequences, PutsThePositionAtZeroFirst) {
  EXPECT_EQ(firstSequences(withAxes({{"0", 17}, {"180", 5}})), (Sequences{0, 17}));
  EXPECT_EQ(firstSequences(withAxes({{"180", 5}, {"0", 17}})), (Sequences{17, 0}));
}

TEST(FirstSequences, FollowTheFileWhereAnAxisComesAgain) {
  EXPECT_EQ(firstSequences(withAxes({{"180", 5}, {"0", 17}, {"180", 2}})), (Sequences{0, 5, 22}));
  EXPECT_EQ(firstSequences(withAxes({{"0", 3}, {"?", 5}, {"0", 7}})), (Sequences{0, 3, 8}));
  EXPECT_EQ(positionsAsTaken(withAxes({{"180", 5}, {"0", 17}, {"180", 2}})), (Sequences{0, 1, 2}));
  EXPECT_EQ(positionsAsTaken(withAxes({{"180", 5}, {"0", 17}, {"", 2}})), (Sequences{1, 0, 2}));
}

TEST(FirstSequences, FollowTheClockIfEachPositionHasATime) {
  Session session = withAxes({{"0", 2}, {"180", 3}});
  const auto setTimes = [&](std::size_t position, const char* hour) {
    for (Reading& row : session.positions[position].readings)
      row.takenAt = std::string("2026-03-01T") + hour + ":00:00Z";
  };
  setTimes(0, "12");
  EXPECT_EQ(positionsAsTaken(session), (Sequences{0, 1})) << "180° has no times";
  setTimes(1, "10");
  EXPECT_EQ(positionsAsTaken(session), (Sequences{1, 0}));
  EXPECT_EQ(firstSequences(session), (Sequences{3, 0}));
}

// Wrongly typed positions keep their place among the others.
TEST(FirstSequences, KeepsTheOrderOfTheFileOtherwise) {
  EXPECT_EQ(firstSequences(withAxes({{"", 3}, {"180", 5}, {"0", 17}})), (Sequences{17, 20, 0}));
  EXPECT_EQ(firstSequences(withAxes({})), Sequences{});
}

TEST(FirstSequences, MakeAMeasurementTheSameInEitherOrderOfTheFile) {
  Session session = test::paperSession();
  session.positions[0].readings[3].excluded = true;
  const Measurement asTaken = test::measurementOf(session);
  std::ranges::reverse(session.positions);
  const Measurement reversed = test::measurementOf(session);
  ASSERT_EQ(reversed.arcs.size(), 2u);
  for (std::size_t arc = 0; arc < 2; ++arc) {
    EXPECT_EQ(reversed.arcs[arc].axisDeg, asTaken.arcs[arc].axisDeg);
    EXPECT_EQ(reversed.arcs[arc].position, 1 - asTaken.arcs[arc].position);
    const auto &ours = reversed.arcs[arc].sightings, &theirs = asTaken.arcs[arc].sightings;
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      EXPECT_EQ(ours[i].sequence, theirs[i].sequence);
      EXPECT_EQ(ours[i].row, theirs[i].row);
      EXPECT_EQ(ours[i].e, theirs[i].e);
    }
  }
  EXPECT_EQ(asTaken.arcs[0].sightings.front().sequence, 0u);
  EXPECT_EQ(asTaken.arcs[1].sightings.front().sequence, 17u);
}

}  // namespace
}  // namespace alidade
