#include "core/adjustment/result/axis_residual_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "tests/support/paper_table.h"

namespace alidade {
namespace {

TEST(AxisMisfit, IsThatOfItsArcWhereThereIsOne) {
  const SessionFit fit = fitSession(test::paperMeasurement());
  for (const int axisDeg : {0, 180}) {
    const AxisResidualSum sum = residualSumAt(fit, axisDeg);
    const ArcFit& arc = *fit.arcAt(axisDeg);
    EXPECT_EQ(sum.sightings, 17u);
    EXPECT_EQ(sum.degreesOfFreedom, arc.degreesOfFreedom);
    EXPECT_DOUBLE_EQ(sum.chiSquare, arc.chiSquare);
    EXPECT_DOUBLE_EQ(sum.residualRms, arc.residualRms);
  }
  EXPECT_EQ(residualSumAt({}, 0).sightings, 0u);
}

/// Each sighting has two readings and one place; both arcs at 0° share centre and radius, three numbers.
TEST(AxisMisfit, CountsWhatTheArcsOfAnAxisShareOnce) {
  Session session = test::paperSession();
  session.positions.push_back(session.positions.front());
  const SessionFit fit = fitSession(*examine(session).measurement);
  const AxisResidualSum upper = residualSumAt(fit, 0), lower = residualSumAt(fit, 180);
  EXPECT_EQ(upper.sightings, 34u);
  EXPECT_EQ(upper.degreesOfFreedom, 34 - 3);
  EXPECT_EQ(lower.degreesOfFreedom, 17 - 3);
  EXPECT_EQ(upper.degreesOfFreedom + lower.degreesOfFreedom, fit.joint.degreesOfFreedom);
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
