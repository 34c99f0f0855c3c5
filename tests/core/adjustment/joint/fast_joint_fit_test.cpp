#include "core/adjustment/joint/fast_joint_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/arc/first_fit.h"
#include "core/base/random_source.h"
#include "tests/support/perfect_session.h"

// Compares the fast adjustment with the general one for all measurements that the fast one accepts.

namespace alidade {
namespace {

void addFacesAndSlider(ArcMeasurement& arc, const std::vector<double>& angles, bool twoFaces, bool slider,
                       RandomSource& random) {
  const double zero = random.uniform(-3, 3);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double phi = angles[i];
    if (slider && random.uniform() < 0.8)
      arc.sightings[i].slider = Angle::fromRadians(zero + (arc.axisDeg == 0 ? phi : -phi));
    if (!twoFaces || random.uniform() > 0.7) continue;
    Sighting other = arc.sightings[i];
    other.face = 2;
    other.row = arc.sightings.size();
    arc.sightings.push_back(other);
  }
}

/// 4 to 60 places on 30° to 330° of arc, L from 0.6 to 24 m, R from 50 to 5000 mm if seen within 40°, σ from
/// 0.1″ to 30″, noise up to three times the stated; one or both positions, and random faces and sliders.
Measurement drawMeasurement(RandomSource& random) {
  Measurement measurement = test::usualMeasurement();
  measurement.distance = 600 * std::exp(random.uniform(0, std::log(40)));
  measurement.relation =
      random.uniform() < 0.8 ? VerticalAngleRelation::Exact : VerticalAngleRelation::Planar;
  const double sigma = 0.1 * std::exp(random.uniform(0, std::log(300)));
  measurement.sigmaHorizontal = Angle::fromArcseconds(sigma);
  measurement.sigmaVertical = Angle::fromArcseconds(sigma * std::exp(random.uniform(-1, 1)));
  measurement.sigmaSlider = Angle::fromArcseconds(10);
  measurement.sigmaZeroHorizontal = measurement.sigmaZeroVertical = Angle::fromArcseconds(sigma);
  measurement.sigmaDistance = 1;
  const double most = std::min(5000.0, 0.8 * measurement.distance);
  const double radius = 50 * std::exp(random.uniform(0, std::log(most / 50)));
  measurement.nominalRadius = radius;
  const double noise = random.uniform(0, 3);
  const int places = random.whole(4, 60), positions = random.whole(1, 2);
  const double span = random.uniform(30, 330);
  for (int position = 0; position < positions; ++position) {
    const Circle circle{random.uniform(-20, 20), random.uniform(-20, 20), radius};
    const std::vector<double> angles = test::spread(places, span, position == 0 ? 90 : 270);
    ArcMeasurement arc = test::perfectArc(measurement, circle, angles, 180 * position);
    addFacesAndSlider(arc, angles, random.uniform() < 0.5, random.uniform() < 0.5, random);
    for (Sighting& sighting : arc.sightings) {
      sighting.a = sighting.a + measurement.sigmaHorizontal * (noise * random.normal());
      sighting.e = sighting.e + measurement.sigmaVertical * (noise * random.normal());
      if (sighting.slider) sighting.slider = *sighting.slider + measurement.sigmaSlider * random.normal();
    }
    measurement.arcs.push_back(arc);
  }
  return measurement;
}

/// Requires that numbers of both fits differ only by rounding: by `share` of the largest of their kind.
void expectAlike(const std::vector<double>& one, const std::vector<double>& other, double share,
                 const char* what) {
  ASSERT_EQ(one.size(), other.size()) << what;
  double greatest = 0;
  for (const double value : other) greatest = std::max(greatest, std::abs(value));
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], share * greatest) << what << i;
}

void expectAlike(const JointFit& fast, const JointFit& general) {
  ASSERT_EQ(fast.unknowns, general.unknowns);
  EXPECT_EQ(fast.considered, general.considered);
  EXPECT_EQ(fast.consideredSigmas, general.consideredSigmas);
  EXPECT_EQ(fast.degreesOfFreedom, general.degreesOfFreedom);
  EXPECT_EQ(fast.converged(), general.converged());
  EXPECT_NEAR(fast.chiSquare, general.chiSquare, 1e-8 * (1 + general.chiSquare));
  for (std::size_t i = 0; i < fast.values.size(); ++i) {
    // Both stop when the next step is below 1e-9 σ; for poor arcs σ is many millimetres.
    const double sigma = std::sqrt(general.cofactor(i, i));
    EXPECT_NEAR(fast.values[i], general.values[i], 1e-9 + 2e-9 * sigma) << i;
    for (std::size_t k = 0; k < fast.values.size(); ++k)
      EXPECT_NEAR(fast.cofactor(i, k), general.cofactor(i, k),
                  1e-6 * sigma * std::sqrt(general.cofactor(k, k)));
  }
  EXPECT_EQ(fast.cofactorWithoutTerms.values, fast.cofactor.values);
  expectAlike(fast.perConsidered, general.perConsidered, 1e-6, "considered");
  ASSERT_EQ(fast.readings.size(), general.readings.size());
  for (std::size_t i = 0; i < fast.readings.size(); ++i) {
    const AdjustedReading &one = fast.readings[i], &other = general.readings[i];
    EXPECT_EQ(one.arc, other.arc);
    EXPECT_EQ(one.sighting, other.sighting);
    EXPECT_EQ(one.kind, other.kind);
    EXPECT_EQ(one.sigma, other.sigma);
    EXPECT_NEAR(one.residual, other.residual, 1e-7 * one.sigma);
    EXPECT_NEAR(one.redundancy, other.redundancy, 1e-7);
    EXPECT_NEAR(one.perReading, other.perReading, 1e-6 * (1 + std::abs(other.perReading)));
  }
  ASSERT_EQ(fast.residualSums.size(), general.residualSums.size());
  for (std::size_t arc = 0; arc < fast.residualSums.size(); ++arc) {
    EXPECT_EQ(fast.residualSums[arc].degreesOfFreedom, general.residualSums[arc].degreesOfFreedom);
    EXPECT_NEAR(fast.residualSums[arc].chiSquare, general.residualSums[arc].chiSquare,
                1e-8 * (1 + general.residualSums[arc].chiSquare));
    ASSERT_EQ(fast.arcAngles[arc].size(), general.arcAngles[arc].size());
    for (std::size_t i = 0; i < fast.arcAngles[arc].size(); ++i)
      EXPECT_NEAR(std::remainder(fast.arcAngles[arc][i] - general.arcAngles[arc][i], 2 * std::acos(-1.0)), 0,
                  1e-9);
  }
}

TEST(FastJointFit, AnswersAsTheGeneralOneWhereItAccepts) {
  constexpr int sessions = 300;
  RandomSource random(5);
  int compared = 0;
  for (int i = 0; i < sessions && !testing::Test::HasFailure(); ++i) {
    const Measurement measurement = drawMeasurement(random);
    std::vector<Circle> starts;
    for (const ArcMeasurement& arc : measurement.arcs)
      if (const auto fit = firstFit(measurement, arc)) starts.push_back(fit->circle);
    if (starts.size() < measurement.arcs.size()) continue;
    const auto fast = fitJointlyFast(measurement, starts);
    const JointFit general = fitJointlyInGeneral(measurement, starts);
    if (!fast || !general.converged()) continue;
    ++compared;
    SCOPED_TRACE(i);
    expectAlike(*fast, general);
  }
  EXPECT_GT(compared, sessions * 9 / 10) << "it is the usual case";
}

TEST(FastJointFit, LeavesToTheGeneralOneWhatItIsNotMadeFor) {
  Measurement measurement = test::usualMeasurement();
  measurement.arcs = {test::perfectArc(measurement, {1, 2, 400}, test::spread(9, 120))};
  const std::vector<Circle> starts{{1, 2, 400}};
  EXPECT_TRUE(fitJointlyFast(measurement, starts));
  EXPECT_FALSE(fitJointlyFast(measurement, {{100, 2, 300}})) << "far off";
  EXPECT_FALSE(fitJointlyFast(measurement, starts, {.terms = {{ErrorTerm::Collimation, 1e-5}}}));
  EXPECT_FALSE(fitJointlyFast(measurement, starts, {.without = {{0, 3, ReadingKind::Vertical}}}));
  measurement.radiusModel = RadiusModel::Common;
  EXPECT_FALSE(fitJointlyFast(measurement, starts));
}

// The start of an adjustment is the result of `fitArc`, to the accuracy of the fast fit.
TEST(FirstFit, IsTheFitOfTheArc) {
  RandomSource random(6);
  for (int i = 0; i < 100; ++i) {
    const Measurement measurement = drawMeasurement(random);
    const ArcMeasurement& arc = measurement.arcs.front();
    const auto first = firstFit(measurement, arc), fit = fitArc(measurement, arc);
    ASSERT_EQ(static_cast<bool>(first), static_cast<bool>(fit)) << i;
    if (!fit || !fit->converged()) continue;
    const double sigma = std::sqrt(fit->cofactor[2][2]);
    EXPECT_NEAR(first->circle.radius, fit->circle.radius, 1e-9 + 2e-9 * sigma) << i;
    EXPECT_NEAR(first->circle.x, fit->circle.x, 1e-9 + 2e-9 * std::sqrt(fit->cofactor[0][0])) << i;
    EXPECT_EQ(first->degreesOfFreedom, fit->degreesOfFreedom);
    EXPECT_NEAR(first->chiSquare, fit->chiSquare, 1e-6 * (1 + fit->chiSquare)) << i;
    EXPECT_NEAR(first->radiusSigma(), fit->radiusSigma(), 1e-3 * fit->radiusSigma()) << i;
    ASSERT_EQ(first->residuals.size(), fit->residuals.size());
    EXPECT_EQ(first->residuals.back().row, fit->residuals.back().row);
  }
}

}  // namespace
}  // namespace alidade
