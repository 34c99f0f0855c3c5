#include "core/adjustment/joint/joint_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/adjustment/arc/arc_fit.h"
#include "core/base/statistics.h"
#include "core/effects/catalogue.h"
#include "core/session/session_file.h"
#include "tests/support/paper_table.h"
#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

std::vector<Circle> startsOf(const Measurement& measurement) {
  std::vector<Circle> starts;
  for (const ArcMeasurement& arc : measurement.arcs) starts.push_back(fitArc(measurement, arc)->circle);
  return starts;
}

JointFit fitted(const Measurement& measurement, const JointFitOptions& options = {}) {
  return fitJointly(measurement, startsOf(measurement), options);
}

double valueOf(const JointFit& fit, const Unknown& unknown) {
  return fit.values.at(fit.indexOf(unknown));
}

// Two formulations of the same problem must have the same minimum: one arc at a time with the nearest points
// projected out, and all at once with the arc angles as unknowns.
TEST(JointFit, AgreesWithTheFitsOfSingleArcs) {
  const Measurement measurement = test::paperMeasurement();
  const JointFit fit = fitted(measurement);
  ASSERT_TRUE(fit.converged());
  for (std::size_t arc = 0; arc < 2; ++arc) {
    const ArcFit alone = *fitArc(measurement, measurement.arcs[arc]);
    EXPECT_NEAR(valueOf(fit, {.kind = Unknown::Kind::CentreX, .arc = arc}), alone.circle.x, 1e-9);
    EXPECT_NEAR(valueOf(fit, {.kind = Unknown::Kind::CentreY, .arc = arc}), alone.circle.y, 1e-9);
    EXPECT_NEAR(valueOf(fit, {.kind = Unknown::Kind::Radius, .arc = arc}), alone.circle.radius, 1e-9);
    EXPECT_NEAR(fit.residualSums[arc].chiSquare, alone.chiSquare, 1e-9 * alone.chiSquare);
    EXPECT_EQ(fit.residualSums[arc].degreesOfFreedom, alone.degreesOfFreedom);
    const std::size_t y = fit.indexOf({.kind = Unknown::Kind::CentreY, .arc = arc});
    EXPECT_NEAR(fit.cofactor(y, y), alone.cofactor[1][1], 1e-9 * alone.cofactor[1][1]);
  }
}

TEST(JointFit, CofactorsAreSquare) {
  const JointFit fit = fitted(test::paperMeasurement());
  ASSERT_EQ(fit.unknowns.size(), 6u);
  for (const SquareMatrix* matrix : {&fit.cofactor, &fit.cofactorWithoutTerms}) {
    EXPECT_EQ(matrix->size, 6u);
    EXPECT_EQ(matrix->values.size(), 36u);
  }
}

TEST(JointFit, ConvergesFromPoorStarts) {
  const Measurement measurement = test::paperMeasurement();
  const JointFit reference = fitted(measurement);
  for (const double radius : {280.0, 520.0})
    for (const double away : {-100.0, 100.0}) {
      const JointFit fit = fitJointly(measurement, {Circle{away, away, radius}, Circle{-away, away, radius}});
      ASSERT_TRUE(fit.converged());
      for (std::size_t i = 0; i < fit.values.size(); ++i)
        EXPECT_NEAR(fit.values[i], reference.values[i], 1e-9);
    }
}

// Readings that are not finite determine neither a minimum nor any value. Two places do not determine the
// three unknowns of an arc.
TEST(JointFit, SaysWhereItsEquationsHaveLostTheirRank) {
  Measurement measurement = test::paperMeasurement();
  measurement.arcs.resize(1);
  std::vector<Sighting>& sightings = measurement.arcs[0].sightings;
  sightings.resize(2);
  const JointFit fit = fitJointly(measurement, {{0, 0, 400}});
  EXPECT_EQ(fit.status, FitStatus::Undetermined);
  EXPECT_FALSE(fit.converged() || fit.isDetermined());
  sightings[0].a = Angle::fromRadians(std::nan(""));
  EXPECT_EQ(fitJointly(measurement, {{0, 0, 400}}).status, FitStatus::Undetermined);
}

// Without a step the fit returns its start. A term has the given start, whatever its prior; a shared radius
// has the mean of the circles', even if another value is known.
TEST(JointFit, StartsWhereItIsTold) {
  Measurement measurement = test::paperMeasurement();
  const std::vector<Circle> starts{{-1, 2, 401}, {3, -4, 405}};
  const double start = 3e-4, prior = -1e-4;
  for (const RadiusModel model : {RadiusModel::Free, RadiusModel::Common, RadiusModel::Known}) {
    measurement.radiusModel = model;
    measurement.sigmaRadius = 0.1;
    const JointFit fit =
        fitJointly(measurement, starts,
                   {.terms = {{ErrorTerm::Collimation, 1e-4, prior, start}}, .maximumIterations = 0});
    EXPECT_EQ(fit.status, FitStatus::TooManyIterations);
    EXPECT_DOUBLE_EQ(valueOf(fit, {.kind = Unknown::Kind::Error, .arc = 0, .term = ErrorTerm::Collimation}),
                     start);
    for (std::size_t arc = 0; arc < 2; ++arc) {
      EXPECT_DOUBLE_EQ(fit.circleOf(arc).x, starts[arc].x);
      EXPECT_DOUBLE_EQ(fit.circleOf(arc).y, starts[arc].y);
      EXPECT_DOUBLE_EQ(fit.circleOf(arc).radius, model == RadiusModel::Free ? starts[arc].radius : 403);
    }
  }
}

// The sensitivities predict, to first order, the change after moving every reading, or L, by a little and
// fitting again. Their dependence on the residuals, which linear theory omits, is some 1e-4 at the residuals
// of Table I.
TEST(JointFit, SensitivitiesToWhatIsConsideredMeetRefits) {
  const Measurement measurement = test::paperMeasurement();
  const JointFit fit = fitted(measurement);
  const auto expectChange = [&](const Measurement& moved, const Unknown& considered, double by) {
    const JointFit refit = fitted(moved);
    const auto c =
        static_cast<std::size_t>(std::ranges::find(fit.considered, considered) - fit.considered.begin());
    ASSERT_LT(c, fit.considered.size());
    double scale = 0;
    for (std::size_t i = 0; i < fit.values.size(); ++i)
      scale = std::max(scale, std::abs(fit.perConsidered[i * fit.considered.size() + c]));
    for (std::size_t i = 0; i < fit.values.size(); ++i)
      EXPECT_NEAR((refit.values[i] - fit.values[i]) / by, fit.perConsidered[i * fit.considered.size() + c],
                  2e-3 * scale);
  };
  const Angle shift = Angle::fromArcseconds(1);

  // The horizontal zero's error decreases readings and the vertical one's increases them, so removing them
  // adds and subtracts the shift.
  Measurement horizontal = measurement, vertical = measurement, farther = measurement;
  for (Sighting& s : horizontal.arcs[0].sightings) s.a = s.a + shift;
  for (Sighting& s : vertical.arcs[0].sightings) s.e = s.e - shift;
  vertical.arcs[0].zeroElevation = vertical.arcs[0].zeroElevation + shift;
  farther.distance += 0.1;
  expectChange(horizontal, {.kind = Unknown::Kind::HorizontalZero, .arc = 0}, shift.radians());
  expectChange(vertical, {.kind = Unknown::Kind::VerticalZero, .arc = 0}, shift.radians());
  expectChange(farther, {.kind = Unknown::Kind::Distance}, 0.1);
}

// Each reading's redundancy and its influence on Δd, compared with a refit after moving that reading by 1″.
TEST(JointFit, RedundancyAndInfluenceMeetRefits) {
  const Measurement measurement = test::trialMeasurement("full");
  const JointFit fit = fitted(measurement);
  const auto intersectionOf = [](const JointFit& f) {
    return (valueOf(f, {.kind = Unknown::Kind::CentreY, .arc = 0}) -
            valueOf(f, {.kind = Unknown::Kind::CentreY, .arc = 1})) /
           2;
  };
  const Angle shift = Angle::fromArcseconds(1);
  for (std::size_t i = 0; i < fit.readings.size(); i += 7) {
    const AdjustedReading& reading = fit.readings[i];
    Measurement moved = measurement;
    Sighting& sighting = moved.arcs[reading.arc].sightings[reading.sighting];
    if (reading.kind == ReadingKind::Horizontal) sighting.a = sighting.a + shift;
    if (reading.kind == ReadingKind::Vertical) sighting.e = sighting.e + shift;
    if (reading.kind == ReadingKind::Slider) sighting.slider = *sighting.slider + shift;
    const JointFit refit = fitJointly(moved, startsOf(measurement));
    EXPECT_NEAR((refit.readings[i].residual - reading.residual) / shift.radians(), reading.redundancy, 1e-3)
        << i;
    EXPECT_NEAR((intersectionOf(refit) - intersectionOf(fit)) / shift.radians(), reading.perReading,
                1e-3 * 2405)
        << i;
  }
}

// The redundancies of all readings add up to the degrees of freedom: the trace of a projector.
TEST(JointFit, RedundanciesAddUpToTheDegreesOfFreedom) {
  for (const char* protocol : {"paper", "paper-slider", "two-face", "full"}) {
    const JointFit fit = fitted(test::trialMeasurement(protocol));
    double sum = 0;
    for (const AdjustedReading& reading : fit.readings) sum += reading.redundancy;
    EXPECT_NEAR(sum, fit.degreesOfFreedom, 1e-6) << protocol;
    for (const ArcResidualSum& arc : fit.residualSums) sum -= arc.degreesOfFreedom;
    EXPECT_NEAR(sum, 0, 1e-6) << protocol;
  }
}

TEST(JointFit, SliderReadingsFixPlacesAlongTheArc) {
  Measurement measurement = test::trialMeasurement("paper-slider");
  const JointFit with = fitted(measurement);
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) sighting.slider.reset();
  const JointFit without = fitted(measurement);
  const Unknown height{.kind = Unknown::Kind::CentreY, .arc = 0};
  EXPECT_LT(with.cofactor(with.indexOf(height), with.indexOf(height)),
            without.cofactor(without.indexOf(height), without.indexOf(height)) / 2);
  // 17 more readings and one more unknown in each position.
  EXPECT_EQ(with.degreesOfFreedom - without.degreesOfFreedom, 2 * (17 - 1));
}

// An excluded reading can be off by any amount and is not counted.
TEST(JointFit, LeavesReadingsOutThatTakeNoPart) {
  const Measurement good = test::trialMeasurement("full");
  Measurement bad = good;
  Angle& reading = bad.arcs[1].sightings[9].e;
  reading = reading + Angle::fromDegrees(1);
  const JointFitOptions options{.without = {{1, 9, ReadingKind::Vertical}}};
  const JointFit fromGood = fitted(good, options), fromBad = fitJointly(bad, startsOf(good), options);
  ASSERT_TRUE(fromGood.converged() && fromBad.converged());
  EXPECT_EQ(fromGood.degreesOfFreedom, fitted(good).degreesOfFreedom - 1);
  for (std::size_t i = 0; i < fromGood.values.size(); ++i)
    EXPECT_NEAR(fromBad.values[i], fromGood.values[i], 1e-9);  // mm, rad: both converged to this
}

std::size_t orderOfRow(const Measurement& measurement, std::size_t sequence) {
  for (const ArcMeasurement& arc : measurement.arcs)
    for (const Sighting& sighting : arc.sightings)
      if (sighting.sequence == sequence) return sighting.order;
  return 0;
}

// The ray tracer knocked the tripod at a stated moment; with the step at that moment only noise remains.
TEST(JointFit, FindsTheJumpOfAKnockedTripod) {
  for (const test::Trial& trial : test::trials()) {
    if (trial.kind != "orientation_jump") continue;
    const double infinite = std::numeric_limits<double>::infinity();
    const auto moment = static_cast<std::size_t>(std::ceil(trial.effects.at("jump")[0].get<double>() *
                                                           static_cast<double>(trial.measurement.rows - 1)));
    const JointFit fit =
        fitted(trial.measurement,
               {.terms = {{ErrorTerm::HorizontalJump, infinite}, {ErrorTerm::VerticalJump, infinite}},
                .jumpBefore = orderOfRow(trial.measurement, moment)});
    ASSERT_TRUE(fit.converged());
    EXPECT_GT(chiSquareUpperTail(fit.chiSquare, fit.degreesOfFreedom).value(), 0.001) << trial.id;
    for (const auto& [term, size] : {std::pair{ErrorTerm::HorizontalJump, 1}, {ErrorTerm::VerticalJump, 2}}) {
      const std::size_t i = fit.indexOf({.kind = Unknown::Kind::Error, .arc = 0, .term = term});
      const double arcsec = Angle::fromRadians(fit.values[i]).arcseconds();
      const double sigma = Angle::fromRadians(std::sqrt(fit.cofactor(i, i))).arcseconds();
      EXPECT_NEAR(arcsec, trial.effects.at("jump")[size].get<double>(), 4 * sigma) << trial.id;
    }
  }
}

// Readings without noise. The tripod is knocked before the given row; afterwards the circles read 30″ more
// and, on the zenith circle, 20″ more. With a jump at this row, residuals vanish and the jump is found. 1e-6
// of χ² is the convergence limit.
TEST(JointFit, StepActsFromTheNamedRowOn) {
  Measurement measurement = test::usualMeasurement();
  for (const int axisDeg : {0, 180})
    measurement.arcs.push_back(
        test::perfectArc(measurement, {0, 0, 400}, test::spread(9, 150, axisDeg == 0 ? 90 : 270), axisDeg));
  constexpr std::size_t knocked = 5;
  for (ArcMeasurement& arc : measurement.arcs)
    for (Sighting& sighting : arc.sightings) {
      sighting.sequence = measurement.rows++;
      if (sighting.sequence < knocked) continue;
      sighting.a = sighting.a + Angle::fromArcseconds(30);
      sighting.e = sighting.e + Angle::fromArcseconds(-20);
    }
  setMoments(measurement);
  const double infinite = std::numeric_limits<double>::infinity();
  const JointFit fit = fitted(
      measurement, {.terms = {{ErrorTerm::HorizontalJump, infinite}, {ErrorTerm::VerticalJump, infinite}},
                    .jumpBefore = knocked});
  ASSERT_TRUE(fit.converged());
  EXPECT_LT(fit.chiSquare, 1e-6);
  const auto arcsec = [&](ErrorTerm term) {
    return Angle::fromRadians(valueOf(fit, {.kind = Unknown::Kind::Error, .arc = 0, .term = term}))
        .arcseconds();
  };
  EXPECT_NEAR(arcsec(ErrorTerm::HorizontalJump), 30, 1e-3);
  EXPECT_NEAR(arcsec(ErrorTerm::VerticalJump), 20, 1e-3);
}

}  // namespace
}  // namespace alidade
