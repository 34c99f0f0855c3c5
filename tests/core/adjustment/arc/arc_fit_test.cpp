#include "core/adjustment/arc/arc_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/wording/findings.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"

namespace alidade {
namespace {

using namespace arc_fault;

struct PaperFigures {
  VerticalAngleRelation relation;
  std::size_t arc;
  double radius, x, y, rms, reducedChiSquare;
};

class ArcFitOfTableI : public testing::TestWithParam<PaperFigures> {};

// The reference is tests/reference/high-precision, solved at 60 digits independently of this program. 1e-9 mm
// is a millionth of the uncertainty and a hundred times the rounding of the readings.
TEST_P(ArcFitOfTableI, MeetsTheHighPrecisionSolution) {
  const PaperFigures& expected = GetParam();
  Measurement measurement = test::paperMeasurement();
  measurement.relation = expected.relation;
  const auto fit = fitArc(measurement, measurement.arcs[expected.arc]);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->converged());
  EXPECT_EQ(fit->degreesOfFreedom, 14);
  EXPECT_NEAR(fit->circle.radius, expected.radius, 1e-9);
  EXPECT_NEAR(fit->circle.x, expected.x, 1e-9);
  EXPECT_NEAR(fit->circle.y, expected.y, 1e-9);
  EXPECT_NEAR(fit->residualRms, expected.rms, 0.01);
  EXPECT_NEAR(fit->reducedChiSquare(), expected.reducedChiSquare, 1e-6 * expected.reducedChiSquare);
}

INSTANTIATE_TEST_SUITE_P(BothRelations, ArcFitOfTableI,
                         testing::Values(PaperFigures{VerticalAngleRelation::Planar, 0, 401.2649179963,
                                                      -0.8356369583343, 0.9600366937638, 27.27, 451.5475288},
                                         PaperFigures{VerticalAngleRelation::Planar, 1, 403.2138503509,
                                                      -1.463620108508, -1.500755437447, 34.18, 708.9302434},
                                         PaperFigures{VerticalAngleRelation::Exact, 0, 401.9540776022,
                                                      -0.8344649353770, 1.035995904681, 9.38, 53.35417276},
                                         PaperFigures{VerticalAngleRelation::Exact, 1, 403.9138212397,
                                                      -1.482783431806, -1.579640609317, 8.34, 42.17362177}));

TEST(ArcFit, ConvergesFromPoorStarts) {
  const Measurement measurement = test::paperMeasurement();
  for (const ArcMeasurement& arc : measurement.arcs) {
    const auto reference = fitArc(measurement, arc);
    ASSERT_TRUE(reference);
    for (const double radius : {280.0, 400.0, 520.0})
      for (const double dx : {-100.0, 0.0, 100.0})
        for (const double dy : {-100.0, 0.0, 100.0}) {
          const auto fit = fitArc(measurement, arc, {.start = Circle{dx, dy, radius}});
          ASSERT_TRUE(fit) << textOf(fit.problem());
          EXPECT_TRUE(fit->converged());
          // Both fits end within 1e-9 σ of the minimum; σ, scaled by the residuals, is 0.1 mm.
          EXPECT_NEAR(fit->circle.x, reference->circle.x, 1e-9);
          EXPECT_NEAR(fit->circle.y, reference->circle.y, 1e-9);
          EXPECT_NEAR(fit->circle.radius, reference->circle.radius, 1e-9);
        }
  }
}

TEST(ArcFit, RecoversTheCircleOfPerfectReadings) {
  for (const auto relation : {VerticalAngleRelation::Exact, VerticalAngleRelation::Planar})
    for (const double span : {20.0, 160.0, 350.0})
      for (const Circle truth : {Circle{0, 0, 400}, Circle{-90, 130, 300}, Circle{20, -700, 900}}) {
        Measurement measurement = test::usualMeasurement();
        measurement.relation = relation;
        const auto fit = fitArc(measurement, test::perfectArc(measurement, truth, test::spread(9, span)));
        ASSERT_TRUE(fit) << textOf(fit.problem());
        // 1e-16 rad of rounding in a reading is 2e-13 mm; a 20° arc magnifies it some hundred times.
        EXPECT_NEAR(fit->circle.x, truth.x, 1e-9);
        EXPECT_NEAR(fit->circle.y, truth.y, 1e-9);
        EXPECT_NEAR(fit->circle.radius, truth.radius, 1e-9);
        EXPECT_LT(fit->residualRms, 1e-8);
      }
}

TEST(ArcFit, ScalesWithTheLengths) {
  Measurement measurement = test::paperMeasurement();
  const auto fit = fitArc(measurement, measurement.arcs[0]);
  measurement.distance *= 3;
  measurement.nominalRadius *= 3;
  const auto scaled = fitArc(measurement, measurement.arcs[0]);
  ASSERT_TRUE(fit && scaled);
  EXPECT_NEAR(scaled->circle.x, 3 * fit->circle.x, 1e-9);
  EXPECT_NEAR(scaled->circle.y, 3 * fit->circle.y, 1e-9);
  EXPECT_NEAR(scaled->circle.radius, 3 * fit->circle.radius, 1e-9);
  EXPECT_NEAR(scaled->chiSquare, fit->chiSquare, 1e-9 * fit->chiSquare);
}

TEST(ArcFit, MirrorsWithTheReadings) {
  const Measurement measurement = test::paperMeasurement();
  ArcMeasurement mirrored = measurement.arcs[0];
  for (Sighting& sighting : mirrored.sightings) {
    sighting.a = -sighting.a;
    sighting.e = -sighting.e;
  }
  mirrored.zeroElevation = -mirrored.zeroElevation;
  const auto fit = fitArc(measurement, measurement.arcs[0]), mirror = fitArc(measurement, mirrored);
  ASSERT_TRUE(fit && mirror);
  EXPECT_NEAR(mirror->circle.x, -fit->circle.x, 1e-9);
  EXPECT_NEAR(mirror->circle.y, -fit->circle.y, 1e-9);
  EXPECT_NEAR(mirror->circle.radius, fit->circle.radius, 1e-9);
}

// Compares the covariance with 4000 simulated arcs. A sample σ of 4000 scatters by 1/√8000 = 1.1 %; the
// tolerance of 5 % is 4.5 times that.
TEST(ArcFit, CovarianceMeetsTheScatterOfSimulatedArcs) {
  Measurement measurement = test::usualMeasurement();
  measurement.sigmaVertical = Angle::fromArcseconds(5);
  const Circle truth{1, -2, 400};
  const ArcMeasurement perfect = test::perfectArc(measurement, truth, test::spread(11, 140, 80));
  const auto reference = fitArc(measurement, perfect);
  ASSERT_TRUE(reference);

  std::mt19937_64 generator(20261121);
  constexpr int count = 4000;
  double xx = 0, yy = 0, rr = 0, yr = 0, chiSquare = 0;
  for (int i = 0; i < count; ++i) {
    ArcMeasurement noisy = perfect;
    test::addNoise(noisy, measurement, generator);
    const auto fit = fitArc(measurement, noisy);
    ASSERT_TRUE(fit && fit->converged());
    const double dx = fit->circle.x - truth.x, dy = fit->circle.y - truth.y,
                 dr = fit->circle.radius - truth.radius;
    xx += dx * dx / count;
    yy += dy * dy / count;
    rr += dr * dr / count;
    yr += dy * dr / count;
    chiSquare += fit->chiSquare / count;
  }
  const Covariance3& q = reference->cofactor;
  EXPECT_NEAR(std::sqrt(xx / q[0][0]), 1, 0.05);
  EXPECT_NEAR(std::sqrt(yy / q[1][1]), 1, 0.05);
  EXPECT_NEAR(std::sqrt(rr / q[2][2]), 1, 0.05);
  EXPECT_NEAR(yr / std::sqrt(yy * rr), q[1][2] / std::sqrt(q[1][1] * q[2][2]), 0.05);
  // The mean of χ² with f = 8 scatters by √(2f/4000) = 0.06.
  EXPECT_NEAR(chiSquare, reference->degreesOfFreedom, 0.3);
}

TEST(ArcFit, RowsOfOneVisitShareTheirPlace) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(5);
  ArcMeasurement once = test::perfectArc(measurement, {0, 0, 400}, test::spread(9, 150));
  test::addNoise(once, measurement, generator);
  ArcMeasurement twice = once;
  for (Sighting sighting : once.sightings) {
    sighting.face = 2;
    twice.sightings.push_back(sighting);
  }
  const auto single = fitArc(measurement, once), pair = fitArc(measurement, twice);
  ASSERT_TRUE(single && pair);
  EXPECT_EQ(single->degreesOfFreedom, 18 - 9 - 3);
  EXPECT_EQ(pair->degreesOfFreedom, 36 - 9 - 3);
  EXPECT_NEAR(pair->circle.y, single->circle.y, 1e-9);
  EXPECT_NEAR(pair->chiSquare, 2 * single->chiSquare, 1e-9 * single->chiSquare);
  EXPECT_NEAR(pair->cofactor[1][1], single->cofactor[1][1] / 2, 1e-12);
}

template <typename Fault>
std::optional<Fault> refusal(const Measurement& measurement, const ArcMeasurement& arc) {
  const auto fit = fitArc(measurement, arc);
  const auto* fault = fit ? nullptr : std::get_if<Fault>(&fit.problem());
  return fault ? std::optional(*fault) : std::nullopt;
}

TEST(ArcFit, SaysWhyReadingsFixNoCircle) {
  const Measurement measurement = test::usualMeasurement();
  const auto at = [&](const std::vector<double>& angles) {
    return test::perfectArc(measurement, {0, 0, 400}, angles);
  };
  EXPECT_EQ(refusal<TooFewPlaces>(measurement, at({}))->places, 0u);
  EXPECT_EQ(refusal<TooFewPlaces>(measurement, at(test::spread(2, 90)))->places, 2u);
  std::vector<double> places(7, 1.0);
  EXPECT_EQ(refusal<PlacesRepeat>(measurement, at(places))->different, 1u);
  places.back() = 2.0;
  EXPECT_EQ(refusal<PlacesRepeat>(measurement, at(places))->different, 2u);
  EXPECT_NEAR(refusal<ArcTooShort>(measurement, at(test::spread(17, 1.5)))->span.degrees(), 1.5, 0.005);

  // y = 0 for every target: a straight line in the plane.
  ArcMeasurement line = at(test::spread(5, 120));
  for (Sighting& sighting : line.sightings) sighting.e = {};
  EXPECT_TRUE(refusal<PlacesOnALine>(measurement, line));
}

// Noise may bend an almost straight row of places to either side. The fit then gives a result or a reason for
// its failure.
TEST(ArcFit, ShortArcsEndInAnAnswerOrAReason) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(11);
  for (const double span : {0.1, 0.5, 1.0, 2.0, 4.0, 8.0})
    for (int i = 0; i < 50; ++i) {
      ArcMeasurement arc = test::perfectArc(measurement, {0, 0, 400}, test::spread(9, span));
      test::addNoise(arc, measurement, generator);
      const auto fit = fitArc(measurement, arc);
      if (!fit) {
        EXPECT_TRUE(std::holds_alternative<ArcTooShort>(fit.problem()) ||
                    std::holds_alternative<RadiusUndetermined>(fit.problem()));
        continue;
      }
      EXPECT_TRUE(std::isfinite(fit->circle.x) && std::isfinite(fit->circle.y) &&
                  std::isfinite(fit->circle.radius));
      EXPECT_TRUE(std::isfinite(fit->cofactor[0][0] + fit->cofactor[1][1] + fit->cofactor[2][2]));
    }
}

TEST(ArcFit, SaysWhyItEnded) {
  const Measurement measurement = test::usualMeasurement();
  const ArcMeasurement arc = test::perfectArc(measurement, {1, 2, 400}, test::spread(17, 160));
  const Circle afar{-30, 30, 420};
  EXPECT_EQ(fitArc(measurement, arc, {.start = afar})->status, FitStatus::Converged);
  const auto brief = fitArc(measurement, arc, {.start = afar, .maximumIterations = 1});
  EXPECT_EQ(brief->status, FitStatus::TooManyIterations);
  EXPECT_EQ(brief->iterations, 1);
  // A fit cannot come nearer than rounding error.
  EXPECT_NE(fitArc(measurement, arc, {.start = afar, .tolerance = 0})->status, FitStatus::Converged);
}

TEST(ArcFit, FitsAHundredThousandPlaces) {
  const Measurement measurement = test::usualMeasurement();
  std::mt19937_64 generator(8);
  ArcMeasurement arc = test::perfectArc(measurement, {1, 2, 400}, test::spread(100000, 160));
  test::addNoise(arc, measurement, generator);
  const auto fit = fitArc(measurement, arc);
  ASSERT_TRUE(fit && fit->converged());
  // σ of the centre is about 0.02 mm · 2/√100000.
  EXPECT_NEAR(fit->circle.y, 2, 1e-3);
}

}  // namespace
}  // namespace alidade
