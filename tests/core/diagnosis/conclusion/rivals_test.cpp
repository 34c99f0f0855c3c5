#include "core/diagnosis/conclusion/rivals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/diagnosis/candidates/gross_error_components.h"
#include "core/diagnosis/candidates/jump_components.h"
#include "core/diagnosis/conclusion/answer.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

constexpr std::size_t lastRow = 16;  // of the first position

/// One pass in one face over 90° of arc around the top, where both circles show an equal share of an error at
/// either end. The horizontal reading of the first position's last row is 60″ wrong.
Measurement misreadAtTheEnd() {
  Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(4);
  for (const int axisDeg : {0, 180}) {
    measurement.arcs.push_back(test::perfectArc(measurement, {0, axisDeg == 0 ? 0.5 : -0.5, 400},
                                                test::spread(17, 90, axisDeg == 0 ? 90 : 270), axisDeg));
    test::addNoise(measurement.arcs.back(), measurement, generator);
    for (Sighting& sighting : measurement.arcs.back().sightings) sighting.sequence = measurement.rows++;
  }
  setMoments(measurement);
  Angle& misread = measurement.arcs[0].sightings[lastRow].a;
  misread = misread + Angle::fromArcseconds(60);
  return measurement;
}

/// Evidence for normal weights whose visible squared length is w²·`square` and which reduce χ² by `gain`,
/// averaged over the widths w (MacKay 1992, the linear model with normal weights).
double evidence(const std::vector<Width>& widths, double square, double gain) {
  double sum = 0;
  for (const Width& width : widths) {
    const double shown = width.sigma * width.sigma * square;
    sum += std::exp(width.logChance + gain / 2 * shown / (1 + shown)) / std::sqrt(1 + shown);
  }
  return sum;
}

// A single condition between the circles of the row shows an error of either circle, or a jump just before
// it. So a jump competes with two gross errors: the odds are those of the priors times the ratio of the
// evidences. The trace of a jump in the next position, a thousandth of it, is neglected: 10 %.
TEST(Rivals, JumpStandsAgainstAGrossErrorOfEitherCircle) {
  const Measurement measurement = misreadAtTheEnd();
  const Inquiry inquiry = inquire(*modelOf(measurement), {}, {});
  const Answer answer = conclude(inquiry);
  ASSERT_EQ(answer.explanation.parts.size(), 1u);
  ASSERT_TRUE(inquiry.of(answer.explanation.parts[0]).grossErrorAt());
  ASSERT_EQ(answer.rivals[0].size(), 1u);
  ASSERT_TRUE(inquiry.of(answer.rivals[0][0].part).isJump());

  const GapModel& base = inquiry.base;
  const JointFit without =
      fitJointly(*base.measurement, base.starts, {.without = {{0, lastRow, ReadingKind::Horizontal}}});
  const double gain = base.fit->chiSquare - without.chiSquare;
  double ofGrossErrors = 0, shown = 0;
  for (const AdjustedReading& reading : base.fit->readings) {
    if (reading.arc != 0 || reading.sighting != lastRow) continue;
    ofGrossErrors += evidence(grossErrorWidths(), reading.redundancy, gain);
    shown += reading.redundancy * std::pow(plausibleJump / reading.sigma, 2);
  }
  const PriorOdds odds;
  const double rows = 34, readings = 2 * rows;
  // Jumps may occur before each row except the first of a position, and last to the end of that position. The
  // zeros may sight different marks.
  const double moments = 16 + 16;
  const double expected = odds.jump / moments * evidence(usualAndFarWiderJumpWidths(), shown, gain) /
                          (odds.grossError / readings * ofGrossErrors);
  EXPECT_NEAR(answer.rivals[0][0].odds, expected, 0.1 * expected);
}

}  // namespace
}  // namespace alidade
