// Every fit of the program compared with solutions at 60 digits (tests/reference/high-precision). 1e-9 mm is
// a millionth of the uncertainty. A reading is rounded to 4e-16 rad, 1e-12 mm at the target, which the
// poorest geometry (20° of arc) magnifies some hundred times.

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/wording/findings.h"
#include "tests/support/high_precision.h"

namespace alidade {
namespace {

constexpr double smallLength = 1e-9;  // mm
/// Relative tolerance of a σ or χ²: the solvers stop within 1e-9 σ of the minimum, where both are smooth.
constexpr double smallShare = 1e-8;

void expectMeets(const ArcFit& fit, const test::ReferenceArc& reference) {
  EXPECT_TRUE(fit.converged());
  EXPECT_EQ(fit.axisDeg, reference.axisDeg);
  EXPECT_NEAR(fit.circle.x, reference.x, smallLength);
  EXPECT_NEAR(fit.circle.y, reference.y, smallLength);
  EXPECT_NEAR(fit.circle.radius, reference.radius, smallLength);
  EXPECT_NEAR(std::sqrt(fit.cofactor[0][0]), reference.sigmaX, smallShare * reference.sigmaX);
  EXPECT_NEAR(std::sqrt(fit.cofactor[1][1]), reference.sigmaY, smallShare * reference.sigmaY);
  EXPECT_NEAR(std::sqrt(fit.cofactor[2][2]), reference.sigmaRadius, smallShare * reference.sigmaRadius);
  EXPECT_NEAR(fit.chiSquare, reference.chiSquare, smallShare * (1 + reference.chiSquare));
}

TEST(HighPrecision, HoldsADozenSessions) {
  EXPECT_GE(test::referenceFits().size(), 12U);
}

TEST(HighPrecision, TheFitOfOneArcMeetsIt) {
  for (const test::ReferenceFit& reference : test::referenceFits()) {
    if (reference.hasSliders()) continue;  // a single arc does not use them
    SCOPED_TRACE(reference.name);
    for (std::size_t i = 0; i < reference.arcs.size(); ++i) {
      const auto fit = fitArc(reference.measurement, reference.measurement.arcs[i]);
      ASSERT_TRUE(fit) << textOf(fit.problem());
      expectMeets(*fit, reference.arcs[i]);
    }
  }
}

TEST(HighPrecision, TheFitOfAWholeSessionMeetsIt) {
  for (const test::ReferenceFit& reference : test::referenceFits()) {
    SCOPED_TRACE(reference.name);
    const SessionFit fit = fitSession(reference.measurement);
    ASSERT_EQ(fit.arcs.size(), reference.arcs.size());
    for (std::size_t i = 0; i < reference.arcs.size(); ++i) expectMeets(fit.arcs[i], reference.arcs[i]);
    ASSERT_EQ(fit.intersection.has_value(), reference.intersection.has_value());
    if (!fit.intersection) continue;
    EXPECT_NEAR(fit.intersection->value, *reference.intersection, smallLength);
    ASSERT_EQ(fit.intersection->budget.front().source, UncertaintySource::Readings);
    EXPECT_NEAR(fit.intersection->budget.front().sigma, fit.noise.factor * *reference.sigmaIntersection,
                smallShare * fit.intersection->sigma);
  }
}

}  // namespace
}  // namespace alidade
