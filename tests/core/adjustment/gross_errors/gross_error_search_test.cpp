#include "core/adjustment/gross_errors/gross_error_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade::test {
namespace {

using testing::ElementsAre;
using ::testing::IsEmpty;
using enum ReadingKind;

std::vector<ReadingRef> cellsOf(const GrossErrorSearch& search) {
  std::vector<ReadingRef> cells;
  for (const GrossError& error : search.grossErrors) cells.push_back(error.cell);
  return cells;
}

/// Two noisy arcs of 17 places, one face.
Measurement noisyMeasurement(unsigned seed) {
  std::mt19937_64 generator(seed);
  Measurement measurement = usualMeasurement();
  measurement.arcs = {perfectArc(measurement, {0.4, 1.2, 400.3}, spread(17, 160), 0),
                      perfectArc(measurement, {0.4, -1.2, 400.3}, spread(17, 160, -90), 180)};
  for (ArcMeasurement& arc : measurement.arcs) addNoise(arc, measurement, generator);
  return measurement;
}

// Sessions of an independent ray tracer with errors of 30″ to 300″ on single readings.
TEST(GrossErrorSearch, FindsTheGrossErrorsOfTheRayTracer) {
  for (const Trial& trial : trials()) {
    if (trial.kind != "gross_error") continue;
    SCOPED_TRACE(trial.id);
    const GrossErrorSearch search = searchGrossErrors(trial.measurement);
    ASSERT_EQ(search.grossErrors.size(), 1u);
    const GrossError& found = search.grossErrors[0];
    const Sighting& sighting = trial.measurement.arcs[found.cell.arc].sightings[found.cell.sighting];
    const auto& grossError = trial.truth.at("blunders").at(0);
    EXPECT_EQ(grossError.at(0), found.cell.arc);
    EXPECT_EQ(grossError.at(1), sighting.round);
    EXPECT_EQ(grossError.at(2), sighting.point);
    EXPECT_EQ(grossError.at(3), sighting.face);
    EXPECT_THAT(found.rivals, IsEmpty());
    // Zenith readings increase downwards, reduced ones upwards; all three are in face 1.
    const double size = found.size.arcseconds() * (found.cell.kind == Horizontal ? 1 : -1);
    EXPECT_NEAR(size, grossError.at(found.cell.kind == Horizontal ? 4 : 5), 4 * found.sigma.arcseconds());
  }
}

// A slider reading of the opposite index is half a turn off, which a fit may find in either direction. In the
// middle of the arc, at 90°, a vertical reading of the opposite place would explain it as well.
TEST(GrossErrorSearch, FindsASliderReadHalfATurnWrong) {
  for (const unsigned row : {1U, 2U, 3U, 4U, 5U, 6U, 10U, 11U, 12U, 13U, 14U, 15U}) {
    Measurement measurement = noisyMeasurement(row);
    measurement.sigmaSlider = Angle::fromArcseconds(5);
    const std::vector<double> places = spread(17, 160);
    for (std::size_t i = 0; i < places.size(); ++i) {
      measurement.arcs[0].sightings[i].slider = Angle::fromRadians(places[i]);
      measurement.arcs[1].sightings[i].slider = Angle::fromRadians(places[places.size() - 1 - i]);
    }
    Sighting& wrong = measurement.arcs[0].sightings[row];
    wrong.slider = *wrong.slider + Angle::fromDegrees(180);
    const GrossErrorSearch search = searchGrossErrors(measurement);
    EXPECT_THAT(cellsOf(search), ElementsAre(ReadingRef{0, row, ReadingKind::Slider})) << row;
  }
}

// Effects of instruments and guideways cause a misfit of the whole session, without a misread reading.
TEST(GrossErrorSearch, BlamesNoReadingForAnEffect) {
  for (const Trial& trial : trials()) {
    if (trial.kind == "gross_error") continue;
    EXPECT_THAT(cellsOf(searchGrossErrors(trial.measurement)), IsEmpty()) << trial.id << ' ' << trial.kind;
  }
}

// The paper's readings scatter seven times as much as stated, and all of them equally.
TEST(GrossErrorSearch, NamesNothingInThePapersReadings) {
  const GrossErrorSearch search = searchGrossErrors(paperMeasurement());
  EXPECT_THAT(search.grossErrors, IsEmpty());
  EXPECT_NEAR(search.noiseFactor, 6.91, 0.005);
}

// 34 rows alone in their visits are 34 tests at 1 % in all: each at 1 − 0.99^(1/34) = 2.956e-4, which
// Student's t with 28 degrees of freedom exceeds beyond ±4.1309 (integrated numerically).
TEST(GrossErrorSearch, NamesASoundReadingInOneSessionOfAHundred) {
  EXPECT_NEAR(searchGrossErrors(paperMeasurement()).criticalValue, 4.1309, 0.0001);
}

// Each of the four shifts the fit of its arc by more than the noise of all others; the largest by metres.
TEST(GrossErrorSearch, FindsSeveralThatWouldMaskEachOther) {
  Measurement measurement = noisyMeasurement(1);
  shiftReading(measurement, {0, 8, Vertical}, Angle::fromDegrees(-10));
  shiftReading(measurement, {0, 9, Vertical}, Angle::fromArcseconds(600));
  shiftReading(measurement, {0, 7, Vertical}, Angle::fromArcseconds(600));
  shiftReading(measurement, {1, 0, Horizontal}, Angle::fromArcseconds(60));
  const GrossErrorSearch search = searchGrossErrors(measurement);
  std::vector<std::pair<std::size_t, std::size_t>> rows;
  for (const GrossError& error : search.grossErrors) rows.emplace_back(error.cell.arc, error.cell.sighting);
  EXPECT_THAT(rows, ::testing::UnorderedElementsAre(std::pair(0, 7), std::pair(0, 8), std::pair(0, 9),
                                                    std::pair(1, 0)));
  EXPECT_EQ(search.grossErrors[0].cell, (ReadingRef{0, 8, Vertical}));
  EXPECT_NEAR(search.grossErrors[0].size.degrees(), 10, 4 * search.grossErrors[0].sigma.degrees());
}

// Without a second face or the slider, a misfit across the arc can come from either circle.
TEST(GrossErrorSearch, SaysThatEitherCircleOfASingleSightingMayBeAtFault) {
  Measurement measurement = noisyMeasurement(2);
  shiftReading(measurement, {1, 4, Vertical}, Angle::fromArcseconds(90));
  const GrossErrorSearch search = searchGrossErrors(measurement);
  ASSERT_EQ(search.grossErrors.size(), 1u);
  ASSERT_EQ(search.grossErrors[0].rivals.size(), 1u);
  EXPECT_EQ(search.grossErrors[0].cell.sighting, 4u);
  EXPECT_EQ(search.grossErrors[0].rivals[0].sighting, 4u);
  EXPECT_NE(search.grossErrors[0].cell.kind, search.grossErrors[0].rivals[0].kind);
}

TEST(GrossErrorSearch, TestsNothingWithoutRedundancy) {
  Measurement measurement = usualMeasurement();
  measurement.arcs = {perfectArc(measurement, {0, 0, 400}, spread(3, 120))};
  shiftReading(measurement, {0, 1, Vertical}, Angle::fromDegrees(1));
  const GrossErrorSearch search = searchGrossErrors(measurement);
  EXPECT_THAT(search.grossErrors, IsEmpty());
  EXPECT_EQ(search.criticalValue, 0);
}

// Rows far off the circle are left out from the start, in any number; at most the requested number is named.
TEST(GrossErrorSearch, AreManagedInThousandsOfReadings) {
  std::mt19937_64 generator(9);
  Measurement measurement = usualMeasurement();
  measurement.arcs = {perfectArc(measurement, {0.4, 1.2, 400.3}, spread(1500, 160), 0)};
  addNoise(measurement.arcs[0], measurement, generator);
  for (std::size_t i = 0; i < 30; ++i)
    shiftReading(measurement, {0, 600 + 10 * i, Vertical}, Angle::fromDegrees(3));
  const GrossErrorSearch search = searchGrossErrors(measurement);
  EXPECT_EQ(search.grossErrors.size(), 12u);
  EXPECT_EQ(search.leftOut.size(), 60u);
  EXPECT_NEAR(search.noiseFactor, 1, 4 / std::sqrt(2 * 1500.0));
}

}  // namespace
}  // namespace alidade::test
