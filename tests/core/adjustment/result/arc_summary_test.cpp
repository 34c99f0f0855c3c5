#include "core/adjustment/result/arc_summary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

TEST(ArcSummary, IsThatOfItsArcWhereThereIsOne) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  const std::vector<ArcSummary> summaries = summariesByAxis(fit);
  ASSERT_EQ(summaries.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const ArcFit& arc = fit.arcs[i];
    EXPECT_EQ(summaries[i].arcs, std::vector{&arc});
    EXPECT_EQ(summaries[i].sightings, 17);
    EXPECT_EQ(summaries[i].degreesOfFreedom, arc.degreesOfFreedom);
    EXPECT_EQ(summaries[i].reducedChiSquare(), arc.reducedChiSquare());
    EXPECT_EQ(summaries[i].residualRms, arc.residualRms);
    EXPECT_EQ(summaries[i].sigma.radius, fit.sigmas[i].radius);
  }
  EXPECT_TRUE(summariesByAxis({}).empty());
}

TEST(ArcSummary, HasNoReducedChiSquareWithoutRedundancy) {
  ArcFit arc;
  arc.chiSquare = 1;
  EXPECT_TRUE(std::isnan(summaryOf(arc, {}).reducedChiSquare()));
}

/// Each sighting has two readings and one place; both arcs at 0° share centre and radius, three numbers.
/// Their readings also determine the difference of their zeros, up to two numbers.
TEST(ArcSummary, CountsWhatTheArcsOfAnAxisShareOnce) {
  Session session = test::paperSession();
  session.positions.push_back(session.positions.front());
  const SessionFit fit = fitSession(*examine(session).measurement);
  const std::vector<ArcSummary> summaries = summariesByAxis(fit);
  ASSERT_EQ(summaries.size(), 2u);
  const ArcSummary &upper = summaries[0], &lower = summaries[1];
  EXPECT_EQ(upper.arcs, (std::vector{&fit.arcs[0], &fit.arcs[2]}));
  EXPECT_EQ(upper.sightings, 34);
  double redundancy = 0;
  for (const AdjustedReading& reading : fit.joint.readings)
    if (reading.arc != 1) redundancy += reading.redundancy;
  EXPECT_NEAR(upper.degreesOfFreedom, redundancy, 1e-6);
  EXPECT_LT(upper.degreesOfFreedom, 34 - 3);
  EXPECT_GT(upper.degreesOfFreedom, 34 - 3 - 2);
  EXPECT_NEAR(lower.degreesOfFreedom, 17 - 3, 1e-6);
  double squares = 0;
  for (const ArcFit& arc : fit.arcs)
    if (arc.axisDeg == 0)
      for (const SightingResidual& residual : arc.residuals)
        squares +=
            std::pow(residual.horizontal.arcseconds(), 2) + std::pow(residual.vertical.arcseconds(), 2);
  EXPECT_NEAR(upper.residualRms, std::sqrt(squares / 68), 1e-9);
}

}  // namespace
}  // namespace alidade
