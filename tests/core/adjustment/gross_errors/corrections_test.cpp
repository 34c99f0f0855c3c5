#include "core/adjustment/gross_errors/corrections.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

int countOf(const std::vector<Correction>& corrections, EntryError error) {
  return static_cast<int>(std::ranges::count(corrections, error, &Correction::error));
}

TEST(Corrections, TryEveryKindOfSlip) {
  const auto corrections = correctionsOf(paperSession(), 0, 5);
  for (const EntryError error :
       {EntryError::DigitsSwapped, EntryError::OneDigitWrong, EntryError::DegreeOff,
        EntryError::TenMinutesOff, EntryError::MinuteOff, EntryError::TenSecondsOff,
        EntryError::CirclesSwapped, EntryError::WrongFace, EntryError::NeighbouringRow})
    EXPECT_GT(countOf(corrections, error), 0) << static_cast<int>(error);
}

TEST(Corrections, ExchangeReadingsWithBothNeighbours) {
  const Session session = paperSession();
  EXPECT_EQ(countOf(correctionsOf(session, 0, 5), EntryError::NeighbouringRow), 6);
  EXPECT_EQ(countOf(correctionsOf(session, 0, 0), EntryError::NeighbouringRow), 3) << "the first row has one";
  for (const Correction& correction : correctionsOf(session, 0, 0))
    if (correction.error == EntryError::NeighbouringRow && correction.changes.size() == 2) {
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
