#include "core/diagnosis/gap/gap_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/adjustment/result/intersection.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

TEST(GapModel, HasOnlyTheArcsThatCanBeFitted) {
  Measurement measurement = test::trialMeasurement("paper");
  measurement.arcs[0].sightings.resize(2);
  const GapModel model = *modelOf(measurement);
  ASSERT_EQ(model.measurement->arcs.size(), 1u);
  EXPECT_EQ(model.measurement->arcs[0].axisDeg, 180);
  EXPECT_EQ(model.starts.size(), 1u);
  EXPECT_EQ(model.fit->arcAngles.size(), 1u);
  EXPECT_EQ(model.noise, 1);
}

// A repeated fit of the model gives the same result to 1e-6 σ, because fits end 1e-9 σ from the minimum.
TEST(GapModel, StartsAndOptionsLeadToItsFit) {
  for (const std::vector<std::string>& effects :
       {std::vector<std::string>{}, {"collimation", "plane_warp"}}) {
    Measurement measurement = test::trialMeasurement("two-face");
    measurement.effects = effects;
    const GapModel model = *modelOf(measurement);
    ASSERT_EQ(model.options.terms.size(), effects.empty() ? 0u : 3u);
    const JointFit again = fitJointly(*model.measurement, model.starts, model.options);
    ASSERT_EQ(again.unknowns, model.fit->unknowns);
    EXPECT_LE(again.iterations, 10);
    for (std::size_t i = 0; i < again.values.size(); ++i)
      EXPECT_NEAR(again.values[i], model.fit->values[i], 1e-6 * std::sqrt(again.cofactor(i, i)));
  }
}

TEST(GapModel, FailsWithTheFirstErrorOfTheFit) {
  SessionFit fit;
  const Measurement empty, measurement = test::trialMeasurement("paper");
  EXPECT_FALSE(modelOf(empty, fit).problem().why);
  fit.findings = {{Severity::Note, {}, session_finding::PlanarRelation{}},
                  {Severity::Error, {}, session_finding::PositionMissing{180}},
                  {Severity::Error, {}, session_finding::UnknownEffect{"gremlins"}}};
  const auto refused = modelOf(measurement, fit);
  ASSERT_FALSE(refused);
  ASSERT_TRUE(refused.problem().why);
  EXPECT_TRUE(std::holds_alternative<session_finding::PositionMissing>(refused.problem().why->what));
}

/// Returns Δd with one reading changed by `sigmas` of its σ.
double intersectionWith(const GapModel& model, const AdjustedReading& reading, double sigmas) {
  Measurement measurement = *model.measurement;
  Sighting& row = measurement.arcs[reading.arc].sightings[reading.sighting];
  const Angle error = statedSigma(measurement, reading.kind) * sigmas;
  if (reading.kind == ReadingKind::Horizontal) row.a = row.a + error;
  if (reading.kind == ReadingKind::Vertical) row.e = row.e + error;
  if (reading.kind == ReadingKind::Slider) row.slider = *row.slider + error;
  return intersect(measurement, fitJointly(measurement, model.starts, model.options))->value;
}

// Fits of perfect readings with one reading changed by ± 1 σ. Second-order terms cancel in the difference;
// third-order terms and the end of the fits 1e-9 σ from the minimum leave 1e-6 of the largest.
TEST(GapModel, InfluenceIsHowFarAReadingMovesTheIntersection) {
  Measurement measurement =
      test::measurementOf(*simulateWithoutNoise(*protocolByName("paper-slider"), drawTruth(6), 6));
  measurement.sigmaVertical = Angle::fromArcseconds(5);
  measurement.sigmaSlider = Angle::fromArcseconds(20);
  const GapModel model = *modelOf(measurement);
  const Eigen::VectorXd influence = influencePerSigma(model);
  ASSERT_EQ(influence.size(), 3 * 34);
  const double most = influence.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < influence.size(); i += 4) {  // readings of each kind in turn
    const AdjustedReading& reading = model.fit->readings[static_cast<std::size_t>(i)];
    const double moved = (intersectionWith(model, reading, 1) - intersectionWith(model, reading, -1)) / 2;
    EXPECT_NEAR(influence[i], moved, 1e-6 * most) << i;
  }
}

// The session completes its rounds in face 1 before those in face 2. Residuals and influences of a fit are
// compared with leftovers index by index, so both list the readings visit by visit. Rounding errors of a
// reading, some 1e-11 rad, are 1e-6 σ.
TEST(GapModel, ReadingRefsNameTheReadingsOfTheLeftover) {
  Measurement measurement = test::trialMeasurement("full");
  measurement.rows = 0;
  for (ArcMeasurement& arc : measurement.arcs) {
    std::ranges::stable_sort(arc.sightings, {}, &Sighting::face);
    for (Sighting& sighting : arc.sightings) sighting.sequence = measurement.rows++;
  }
  setMoments(measurement);
  const GapModel model = *modelOf(measurement);
  const Leftover leftover(linearise(*model.measurement, *model.fit, model.options));
  ASSERT_EQ(leftover.readings(), std::ssize(model.fit->readings));
  int facesApart = 0;
  for (Eigen::Index i = 0; i < leftover.readings(); ++i) {
    const AdjustedReading& reading = model.fit->readings[static_cast<std::size_t>(i)];
    const ReadingRef ref{reading.arc, reading.sighting, reading.kind};
    EXPECT_EQ(readingRef(leftover, i), ref) << i;
    EXPECT_NEAR(leftover.reading(i).residual, reading.residual / reading.sigma, 1e-6) << i;
    if (i > 0) facesApart += ref.sighting > readingRef(leftover, i - 1).sighting + 1;
  }
  EXPECT_GT(facesApart, 0);
}

}  // namespace
}  // namespace alidade
