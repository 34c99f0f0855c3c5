#include "core/adjustment/result/row_repeats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/base/random_source.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using testing::ElementsAre, testing::IsEmpty, testing::Pair;

/// The reading of an arc: the number of places along 160°, the rounds, and the grid in arcseconds.
struct Reader {
  int places = 17, rounds = 1;
  double gridArcseconds = 1, noiseArcseconds = 2;
  bool isRenumbered = false;  ///< every row has a different number

  ArcMeasurement read(const Measurement& measurement, RandomSource& random) const {
    const ArcMeasurement places160 =
        test::perfectArc(measurement, Circle{0.3, -0.4, 400}, test::spread(places, 160));
    ArcMeasurement arc = places160;
    arc.sightings.clear();
    const auto shown = [&](Angle angle) {
      const double read = angle.arcseconds() + noiseArcseconds * random.normal();
      return Angle::fromArcseconds(gridArcseconds * std::round(read / gridArcseconds));
    };
    for (int round = 1; round <= rounds; ++round)
      for (Sighting row : places160.sightings) {
        row.a = shown(row.a);
        row.e = shown(row.e);
        row.round = isRenumbered ? 1 : round;
        row.row = arc.sightings.size();
        if (isRenumbered) row.point = static_cast<int>(row.row) + 1;
        arc.sightings.push_back(row);
      }
    return arc;
  }
};

auto repeatsOf(const Measurement& measurement, const ArcMeasurement& arc) {
  return repeatedRows(measurement, arc, *fitArc(measurement, arc));
}

void copy(ArcMeasurement& arc, std::size_t from, std::size_t to) {
  arc.sightings[to].a = arc.sightings[from].a;
  arc.sightings[to].e = arc.sightings[from].e;
}

/// The number, of 400 sessions of honest readings, in which rows are reported as copies.
int falseAlarms(const Reader& reader) {
  const Measurement measurement = test::usualMeasurement();
  RandomSource random(12);
  int alarms = 0;
  for (int i = 0; i < 400; ++i) {
    const ArcMeasurement arc = reader.read(measurement, random);
    if (!repeatsOf(measurement, arc).empty()) ++alarms;
  }
  return alarms;
}

// One of a hundred sessions may be reported, which is 4 of 400; 12 has a probability of 1 in 2000. Without
// allowing for chance all sessions of six rounds read to whole seconds would be reported, and every second
// one of two rounds.
TEST(RowRepeats, AreNotMadeOfChance) {
  for (const double grid : {5.0, 1.0, 0.5, 0.1, 0.324})
    for (const int rounds : {1, 2, 6})
      EXPECT_LE(falseAlarms({.rounds = rounds, .gridArcseconds = grid}), 12)
          << rounds << " rounds on a grid of " << grid << " arcsec";
  EXPECT_LE(falseAlarms({.rounds = 4, .noiseArcseconds = 0.3}), 12) << "as good as always alike";
  EXPECT_LE(falseAlarms({.rounds = 2, .isRenumbered = true}), 12) << "there and back, numbers of their own";
}

// Sixty thousand places are 1.6″ apart: rows of neighbours are then equal by chance.
TEST(RowRepeats, AreNotMadeOfPlacesThatLieNearEachOther) {
  const Measurement measurement = test::usualMeasurement();
  RandomSource random(5);
  ArcMeasurement arc = Reader{.places = 60000}.read(measurement, random);
  std::size_t alike = 0;
  for (std::size_t i = 1; i < arc.sightings.size(); ++i)
    alike += arc.sightings[i].a == arc.sightings[i - 1].a && arc.sightings[i].e == arc.sightings[i - 1].e;
  EXPECT_GT(alike, 100u);
  EXPECT_THAT(repeatsOf(measurement, arc), IsEmpty());
}

TEST(RowRepeats, AreOneCopiedRow) {
  const Measurement measurement = test::usualMeasurement();
  for (const double grid : {1.0, 0.1, 1e-6}) {
    RandomSource random(7);
    ArcMeasurement arc = Reader{.gridArcseconds = grid}.read(measurement, random);
    copy(arc, 3, 11);
    EXPECT_THAT(repeatsOf(measurement, arc), ElementsAre(Pair(3, 11))) << grid;
  }
}

// A copied round repeats far more readings than the one pair expected by chance in three sessions.
TEST(RowRepeats, AreACopiedRound) {
  const Measurement measurement = test::usualMeasurement();
  RandomSource random(9);
  ArcMeasurement arc = Reader{.rounds = 2}.read(measurement, random);
  for (std::size_t i = 0; i < 17; ++i) copy(arc, i, 17 + i);
  EXPECT_EQ(repeatsOf(measurement, arc).size(), 17u);
}

// On a grid of a tenth of a second, one row copied from the round before is enough.
TEST(RowRepeats, AreOneRowOfTheRoundBeforeOnAFineGrid) {
  const Measurement measurement = test::usualMeasurement();
  RandomSource random(11);
  ArcMeasurement arc = Reader{.rounds = 2, .gridArcseconds = 0.1}.read(measurement, random);
  copy(arc, 4, 21);
  EXPECT_THAT(repeatsOf(measurement, arc), ElementsAre(Pair(4, 21)));
}

TEST(GridOf, IsTheCoarsestThatAllReadingsStandOn) {
  RandomSource random(2);
  for (const double grid : {60.0, 5.0, 1.0, 0.5, 0.1, 0.324, 0.01, 0.001}) {
    std::vector<double> read;
    for (int i = 0; i < 12; ++i)
      read.push_back(Angle::fromArcseconds(12.3456 + grid * random.whole(-200000, 200000)).radians());
    EXPECT_DOUBLE_EQ(gridOf(read), Angle::fromArcseconds(grid).radians()) << grid;
    read.push_back(read.back() + Angle::fromArcseconds(grid / std::numbers::pi).radians());
    EXPECT_LT(gridOf(read), Angle::fromArcseconds(grid).radians()) << grid;
  }
}

// The reference is 100 000 drawn pairs; the tolerance is four of their σ.
TEST(ChanceOfBeingAlike, IsAsOftenAsTwoReadingsAre) {
  RandomSource random(4);
  for (const double grid : {0.2, 1.0, 3.0, 20.0}) {
    int alike = 0;
    constexpr int pairs = 100000;
    for (int i = 0; i < pairs; ++i) {
      const double angle = random.uniform(0, grid);
      const auto shown = [&] { return std::round((angle + random.normal()) / grid); };
      if (shown() == shown()) ++alike;
    }
    EXPECT_NEAR(chanceOfBeingAlike(grid, 1), static_cast<double>(alike) / pairs, 0.0064) << grid;
  }
  EXPECT_EQ(chanceOfBeingAlike(0, 1), 0);
  EXPECT_EQ(chanceOfBeingAlike(1, 0), 1);
}

}  // namespace
}  // namespace alidade
