#include "core/adjustment/gross_errors/corrections.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

int countOf(const std::vector<Correction>& corrections, EntrySlip slip) {
  return static_cast<int>(std::ranges::count(corrections, slip, &Correction::slip));
}

TEST(Corrections, TryEveryKindOfSlip) {
  const auto corrections = correctionsOf(paperSession(), 0, 5);
  for (const EntrySlip slip : {EntrySlip::DigitsSwapped, EntrySlip::OneDigitWrong, EntrySlip::DegreeOff,
                               EntrySlip::TenMinutesOff, EntrySlip::MinuteOff, EntrySlip::TenSecondsOff,
                               EntrySlip::CirclesSwapped, EntrySlip::WrongFace, EntrySlip::NeighbouringRow})
    EXPECT_GT(countOf(corrections, slip), 0) << static_cast<int>(slip);
}

TEST(Corrections, ExchangeReadingsWithBothNeighbours) {
  const Session session = paperSession();
  EXPECT_EQ(countOf(correctionsOf(session, 0, 5), EntrySlip::NeighbouringRow), 6);
  EXPECT_EQ(countOf(correctionsOf(session, 0, 0), EntrySlip::NeighbouringRow), 3) << "the first row has one";
  for (const Correction& correction : correctionsOf(session, 0, 0))
    if (correction.slip == EntrySlip::NeighbouringRow && correction.changes.size() == 2) {
      const std::string Reading::*column =
          correction.changes[0].where.field == "vertical" ? &Reading::vertical : &Reading::horizontal;
      EXPECT_EQ(correction.rows.at(0).*column, session.positions[0].readings[1].*column);
      EXPECT_EQ(correction.rows.at(1).*column, session.positions[0].readings[0].*column);
    }
}

TEST(Corrections, ReadARowAsTheWholeSessionDoes) {
  Session session = paperSession();
  session.positions[1].readings[3].point.clear();
  const Measurement measurement = measurementOf(session);
  RowReader reader(session);
  for (std::size_t position = 0; position < 2; ++position)
    for (const Sighting& expected : measurement.arcs[position].sightings) {
      const auto read =
          reader.read(position, expected.row, session.positions[position].readings[expected.row]);
      ASSERT_TRUE(read);
      EXPECT_EQ(read->a, expected.a);
      EXPECT_EQ(read->e, expected.e);
      EXPECT_EQ(read->point, expected.point);
      EXPECT_EQ(read->row, expected.row);
      EXPECT_EQ(read->sequence, expected.sequence);
    }
  Reading unusable = session.positions[0].readings[0];
  unusable.horizontal = "far";
  EXPECT_FALSE(reader.read(0, 0, unusable));
}

}  // namespace
}  // namespace alidade::test
