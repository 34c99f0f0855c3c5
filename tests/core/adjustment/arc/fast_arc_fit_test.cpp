#include "core/adjustment/arc/fast_arc_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/observation/zero_line.h"
#include "tests/support/high_precision.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

constexpr double smallLength = 1e-9;  // mm

ArcSetup setupOf(const Measurement& measurement) {
  return {measurement.distance, measurement.sigmaHorizontal.radians(), measurement.sigmaVertical.radians(),
          measurement.relation};
}

struct Columns {
  std::vector<double> a, e;
};

/// Returns the readings, counted from the horizon.
Columns columnsOf(const ArcMeasurement& arc) {
  Columns columns;
  for (const Sighting& sighting : arc.sightings) {
    columns.a.push_back(sighting.a.radians());
    columns.e.push_back((sighting.e + arc.zeroElevation).radians());
  }
  return columns;
}

std::optional<FastArcFit> fitFast(const Measurement& measurement, const ArcMeasurement& arc) {
  const Columns columns = columnsOf(arc);
  std::optional<FastArcFit> fit = fitArcFast(setupOf(measurement), columns.a, columns.e);
  if (fit) fit->circle.y -= ZeroLine(measurement, arc).height();
  return fit;
}

/// Fits with Levenberg-Marquardt and the general foot points, from a distant start.
ArcFit fitGenerally(const Measurement& measurement, const ArcMeasurement& arc, const Circle& near) {
  const auto fit = fitArc(measurement, arc, {.start = Circle{near.x + 3, near.y - 2, near.radius * 1.01}});
  if (!fit || !fit->converged()) throw std::runtime_error("the general fit found no minimum");
  return *fit;
}

void expectSame(const FastArcFit& fast, const ArcFit& general, double ofCofactor = 1e-5) {
  // The general fit stops within 1e-9 σ of the minimum, which matters if σ is some millimetres.
  const double small = smallLength + 3e-9 * std::sqrt(general.cofactor[1][1] + general.cofactor[2][2]);
  EXPECT_NEAR(fast.circle.x, general.circle.x, small);
  EXPECT_NEAR(fast.circle.y, general.circle.y, small);
  EXPECT_NEAR(fast.circle.radius, general.circle.radius, small);
  EXPECT_NEAR(fast.chiSquare, general.chiSquare, 1e-8 * (1 + general.chiSquare));
  // The last linearisation is at most a micrometre from the minimum.
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(fast.cofactor[i][j], general.cofactor[i][j],
                  ofCofactor * std::sqrt(general.cofactor[i][i] * general.cofactor[j][j]));
}

TEST(FastArcFit, MeetsTheHighPrecisionSolutions) {
  int met = 0;
  for (const test::ReferenceFit& reference : test::referenceFits()) {
    if (reference.hasSliders() || reference.name == "two-faces") continue;  // pairs of single rows only
    SCOPED_TRACE(reference.name);
    for (std::size_t i = 0; i < reference.arcs.size(); ++i) {
      const auto fit = fitFast(reference.measurement, reference.measurement.arcs[i]);
      ASSERT_TRUE(fit);
      EXPECT_NEAR(fit->circle.x, reference.arcs[i].x, smallLength);
      EXPECT_NEAR(fit->circle.y, reference.arcs[i].y, smallLength);
      EXPECT_NEAR(fit->circle.radius, reference.arcs[i].radius, smallLength);
      // The cofactor belongs to the circle before the last step, some micrometres away.
      EXPECT_NEAR(std::sqrt(fit->cofactor[1][1]), reference.arcs[i].sigmaY, 2e-6 * reference.arcs[i].sigmaY);
      EXPECT_NEAR(fit->chiSquare, reference.arcs[i].chiSquare, 1e-8 * (1 + reference.arcs[i].chiSquare));
      ++met;
    }
  }
  EXPECT_GE(met, 24);
}

// Random geometries: every fit that the fast one accepts is the minimum that the general fit finds from
// another start.
TEST(FastArcFit, IsTheGeneralFitOnWhateverItAccepts) {
  std::mt19937_64 generator(20261121);
  std::uniform_real_distribution<double> uniform;
  int accepted = 0;
  for (int i = 0; i < 500; ++i) {
    Measurement measurement = test::usualMeasurement();
    measurement.distance = std::exp(std::log(600) + uniform(generator) * std::log(40));
    measurement.relation = i % 3 ? VerticalAngleRelation::Exact : VerticalAngleRelation::Planar;
    const double noise = std::exp(std::log(0.1) + uniform(generator) * std::log(300));  // to 30″
    measurement.sigmaHorizontal = Angle::fromArcseconds(noise);
    measurement.sigmaVertical = Angle::fromArcseconds(noise * std::exp(2 * uniform(generator) - 1));
    const Circle circle{40 * uniform(generator) - 20, 40 * uniform(generator) - 20,
                        100 + 400 * uniform(generator)};
    const double span = 30 + 320 * uniform(generator);
    const auto places = static_cast<int>(4 + 40 * uniform(generator));
    ArcMeasurement arc =
        test::perfectArc(measurement, circle, test::spread(places, span, 360 * uniform(generator)));
    test::addNoise(arc, measurement, generator);
    const auto fast = fitFast(measurement, arc);
    if (!fast) continue;
    SCOPED_TRACE(i);
    expectSame(*fast, fitGenerally(measurement, arc, fast->circle));
    ++accepted;
  }
  EXPECT_GE(accepted, 467);  // refused are angles above 45° and noise beyond the sagitta of the arc
}

TEST(FastArcFit, ManyAtOnceAreTheSingleOnes) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(7);
  constexpr std::size_t fits = 43;  // ten groups of four, and three left over
  constexpr std::size_t bad = 17;
  Columns all;
  std::vector<ArcMeasurement> arcs;
  for (std::size_t j = 0; j < fits; ++j) {
    arcs.push_back(
        test::perfectArc(measurement, {1.0 * static_cast<double>(j), 2, 400}, test::spread(17, 150)));
    test::addNoise(arcs.back(), measurement, generator);
    if (j == bad) arcs.back().sightings[3].a = Angle::fromDegrees(50);
    const Columns columns = columnsOf(arcs.back());
    all.a.insert(all.a.end(), columns.a.begin(), columns.a.end());
    all.e.insert(all.e.end(), columns.e.begin(), columns.e.end());
  }
  std::vector<std::optional<FastArcFit>> result(fits);
  fitArcsFast(setupOf(measurement), all.a, all.e, result);
  for (std::size_t j = 0; j < fits; ++j) {
    ASSERT_EQ(result[j].has_value(), j != bad) << j;
    if (j == bad) continue;
    const auto alone = fitFast(measurement, arcs[j]);
    EXPECT_NEAR(result[j]->circle.x, alone->circle.x, smallLength);
    EXPECT_NEAR(result[j]->circle.y, alone->circle.y, smallLength);
    EXPECT_NEAR(result[j]->circle.radius, alone->circle.radius, smallLength);
    EXPECT_NEAR(result[j]->cofactor[1][1], alone->cofactor[1][1], 2e-6 * alone->cofactor[1][1]);
  }
  for (const int threads : {2, 3, 16}) {
    std::vector<std::optional<FastArcFit>> parallel(fits);
    fitArcsFast(setupOf(measurement), all.a, all.e, parallel, threads);
    for (std::size_t j = 0; j < fits; ++j) {
      ASSERT_EQ(parallel[j].has_value(), result[j].has_value());
      const auto circleOf = [](const auto& fit) { return fit ? fit->circle : Circle{}; };
      EXPECT_EQ(circleOf(parallel[j]), circleOf(result[j]));
    }
  }
}

// Above some ten thousand places the fit does not store them: the minimum is the same, and the residuals are
// consistent with its χ².
TEST(FastArcFit, ManyPlacesMeetTheGeneralFit) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(3);
  ArcMeasurement arc = test::perfectArc(measurement, {1, 2, 400}, test::spread(80001, 160));
  test::addNoise(arc, measurement, generator);
  const Columns columns = columnsOf(arc);
  std::vector<double> horizontal(80001), vertical(80001);
  const auto fast = fitArcFast(setupOf(measurement), columns.a, columns.e, {}, {horizontal, vertical});
  ASSERT_TRUE(fast);
  const ArcFit general = fitGenerally(measurement, arc, fast->circle);
  expectSame(*fast, general);
  const double unit = std::numbers::pi / 180 / 3600;
  for (std::size_t i = 0; i < horizontal.size(); i += 997) {
    EXPECT_NEAR(horizontal[i], general.residuals[i].horizontal.radians(), 1e-7 * unit);
    EXPECT_NEAR(vertical[i], general.residuals[i].vertical.radians(), 1e-7 * unit);
  }
}

// Fits a part of the places, taken in blocks, first: neither the order of the places nor a pattern in the
// order may matter.
TEST(FastArcFit, ManyPlacesInAnyOrder) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(4);
  ArcMeasurement arc = test::perfectArc(measurement, {-2, 1, 400}, test::spread(70003, 120));
  test::addNoise(arc, measurement, generator);
  const Columns inOrder = columnsOf(arc);
  const auto ordered = fitArcFast(setupOf(measurement), inOrder.a, inOrder.e);
  std::ranges::shuffle(arc.sightings, generator);
  const Columns columns = columnsOf(arc);
  const auto shuffled = fitArcFast(setupOf(measurement), columns.a, columns.e);
  ASSERT_TRUE(ordered && shuffled);
  EXPECT_NEAR(shuffled->circle.x, ordered->circle.x, smallLength);
  EXPECT_NEAR(shuffled->circle.y, ordered->circle.y, smallLength);
  EXPECT_NEAR(shuffled->circle.radius, ordered->circle.radius, smallLength);
  EXPECT_NEAR(shuffled->cofactor[1][1], ordered->cofactor[1][1], 2e-6 * ordered->cofactor[1][1]);
}

// Systematic errors: each place is off by 6″, as from an unmodelled effect.
TEST(FastArcFit, ManyPlacesWithSystematicErrorsMeetTheGeneralFit) {
  const Measurement measurement = test::usualMeasurement();
  ArcMeasurement arc = test::perfectArc(measurement, {-2, 1, 400}, test::spread(70003, 120));
  for (std::size_t i = 0; i < arc.sightings.size(); ++i) {
    const double turn = 9e-5 * static_cast<double>(i);
    arc.sightings[i].a = arc.sightings[i].a + Angle::fromArcseconds(6 * std::sin(3 * turn));
    arc.sightings[i].e = arc.sightings[i].e + Angle::fromArcseconds(6 * std::cos(2 * turn + 1));
  }
  const auto fast = fitFast(measurement, arc);
  ASSERT_TRUE(fast);
  // Second derivatives contain the residuals times the curvature of the arc, which do not average out. Their
  // share is 6″ · L/R.
  expectSame(*fast, fitGenerally(measurement, arc, fast->circle), 1e-4);
}

TEST(FastArcFit, ResidualsAreThoseOfTheGeneralFit) {
  const Measurement measurement = test::paperMeasurement();
  const ArcMeasurement& arc = measurement.arcs[0];
  const Columns columns = columnsOf(arc);
  std::vector<double> horizontal(columns.a.size()), vertical(columns.a.size());
  const auto fast = fitArcFast(setupOf(measurement), columns.a, columns.e, {}, {horizontal, vertical});
  ASSERT_TRUE(fast);
  const ArcFit general = fitGenerally(measurement, arc, fast->circle);
  for (std::size_t i = 0; i < horizontal.size(); ++i) {
    // 1e-7″ is a nanometre at the target.
    EXPECT_NEAR(Angle::fromRadians(horizontal[i]).arcseconds(), general.residuals[i].horizontal.arcseconds(),
                1e-7);
    EXPECT_NEAR(Angle::fromRadians(vertical[i]).arcseconds(), general.residuals[i].vertical.arcseconds(),
                1e-7);
  }
}

TEST(FastArcFit, WeighsAMeanByItsRows) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(5);
  ArcMeasurement once = test::perfectArc(measurement, {0, 0, 400}, test::spread(9, 150));
  test::addNoise(once, measurement, generator);
  ArcMeasurement twice = once;
  std::vector<double> rows(once.sightings.size(), 1);
  for (const std::size_t i : {1U, 4U, 7U}) {
    twice.sightings.push_back(once.sightings[i]);
    twice.sightings.back().face = 2;
    rows[i] = 2;
  }
  const Columns columns = columnsOf(once);
  const auto fast = fitArcFast(setupOf(measurement), columns.a, columns.e, rows);
  ASSERT_TRUE(fast);
  expectSame(*fast, fitGenerally(measurement, twice, fast->circle));
}

TEST(FastArcFit, RefusesWhatItCannot) {
  Measurement measurement = test::usualMeasurement();
  const auto refuses = [&](const Circle& circle, const std::vector<double>& angles) {
    return !fitFast(measurement, test::perfectArc(measurement, circle, angles)).has_value();
  };
  EXPECT_TRUE(refuses({0, 0, 400}, {}));
  EXPECT_TRUE(refuses({0, 0, 400}, test::spread(2, 90)));
  EXPECT_TRUE(refuses({0, 0, 400}, std::vector<double>(7, 1.0)));
  EXPECT_TRUE(refuses({0, 0, 400}, test::spread(17, 2)));     // almost straight
  EXPECT_TRUE(refuses({0, 0, 3000}, test::spread(17, 150)));  // angles above 45°
  ArcMeasurement misread = test::perfectArc(measurement, {0, 0, 400}, test::spread(17, 150));
  misread.sightings[8].e = misread.sightings[8].e + Angle::fromDegrees(1);
  EXPECT_FALSE(fitFast(measurement, misread));
  misread.sightings[8].e = Angle::fromRadians(std::nan(""));
  EXPECT_FALSE(fitFast(measurement, misread));
}

}  // namespace
}  // namespace alidade
