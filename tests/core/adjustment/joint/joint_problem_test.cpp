#include "core/adjustment/joint/joint_problem.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/adjustment/arc/arc_fit.h"
#include "tests/support/perfect_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

std::vector<Circle> arcsAlone(const Measurement& measurement) {
  std::vector<Circle> starts;
  for (const ArcMeasurement& arc : measurement.arcs) starts.push_back(fitArc(measurement, arc)->circle);
  return starts;
}

/// Each way to set up the equations: for a perfect instrument, with the guideway's terms or with all terms;
/// for one face and two, with slider and without.
struct Case {
  std::string name;
  Measurement measurement;
  JointFitOptions options;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* protocol, RadiusModel radius, std::vector<EstimatedTerm> terms) {
    Case one{protocol, test::trialMeasurement(protocol), {.terms = std::move(terms)}};
    one.name += " with " + std::to_string(one.options.terms.size()) + " terms";
    one.measurement.radiusModel = radius;
    one.measurement.sigmaRadius = 0.2;
    one.measurement.nominalRadius += 0.5;
    one.measurement.sigmaVertical = one.measurement.sigmaHorizontal * 2.5;
    one.options.jumpBefore = 11;
    all.push_back(std::move(one));
  };
  std::vector<EstimatedTerm> every;
  for (std::size_t term = 0; term < errorTermCount; ++term)
    every.push_back({static_cast<ErrorTerm>(term), 1e-3, 2e-5, 1e-5});
  add("paper", RadiusModel::Free, {});
  add("full", RadiusModel::Known, {});
  add("paper-slider", RadiusModel::Common,
      {{ErrorTerm::SliderSine, 1e-3, 1e-4}, {ErrorTerm::PlaneTiltX, 1e-3}});
  add("two-face", RadiusModel::Known, {{ErrorTerm::Collimation, 1e-4, 1e-5, 3e-5}});
  add("full", RadiusModel::Free, every);
  return all;
}

// Readings of perfect arcs, from wrong zeros: by definition the zero's error decreases horizontal readings
// and increases vertical ones, and a zero read as level is inclined. Rounding in a reading is 1e-16 rad,
// 1e-11 σ.
TEST(JointProblem, PerfectReadingsLeaveNothing) {
  for (const auto relation : {VerticalAngleRelation::Exact, VerticalAngleRelation::Planar}) {
    Measurement measurement = test::usualMeasurement();
    measurement.relation = relation;
    const std::vector<Circle> circles{{1, -2, 398}, {-3, 4, 403}};
    const std::vector<double> angles = test::spread(7, 300, 20);
    const Angle horizontal = Angle::fromArcseconds(40), vertical = Angle::fromArcseconds(70);
    ArcMeasurement asGiven = {};
    asGiven.zeroElevation = vertical;
    for (std::size_t i = 0; i < 2; ++i) {
      ArcMeasurement& arc =
          measurement.arcs.emplace_back(test::perfectArc(measurement, circles[i], angles, i == 0 ? 0 : 180));
      for (std::size_t k = 0; k < angles.size(); ++k) {
        arc.sightings[k].slider = Angle::fromRadians(i == 0 ? angles[k] : -angles[k]);
        if (i == 0) continue;
        const Direction<double> seen =
            ZeroLine(measurement, asGiven).observe(ZeroLine(measurement, {}).sightedPoint(arc.sightings[k]));
        arc.sightings[k].a = Angle::fromRadians(seen.a) - horizontal;
        arc.sightings[k].e = Angle::fromRadians(seen.e) + vertical;
      }
    }
    const JointProblem problem(measurement, {});
    JointState state = problem.start(circles);
    for (std::size_t i = 0; i < problem.considered().size(); ++i) {
      const Unknown& unknown = problem.considered()[i];
      double& value = state.unknowns[static_cast<Index>(problem.estimated().size() + i)];
      if (unknown == Unknown{.kind = Unknown::Kind::HorizontalZero, .arc = 1}) value = horizontal.radians();
      if (unknown == Unknown{.kind = Unknown::Kind::VerticalZero, .arc = 1}) value = vertical.radians();
    }
    for (std::size_t i = 0; i < problem.estimated().size(); ++i)
      if (problem.estimated()[i].kind == Unknown::Kind::SliderZero) state.unknowns[static_cast<Index>(i)] = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
      EXPECT_NEAR(std::remainder(state.arcAngles[static_cast<Index>(k)] - angles[k], 2 * std::numbers::pi), 0,
                  1e-12);
      state.arcAngles[static_cast<Index>(angles.size() + k)] = angles[k];
    }
    EXPECT_LT(problem.system(state).chiSquare, 1e-15);
  }
}

// The state holds differences from the prior values: a radius of 400 mm, a term of 1e-5.
TEST(JointProblem, StartsAtTheCirclesAndTermsGiven) {
  Measurement measurement = test::trialMeasurement("two-face");
  measurement.radiusModel = RadiusModel::Known;
  measurement.nominalRadius = 400;
  const JointProblem problem(measurement, {.terms = {{ErrorTerm::Collimation, 1e-4, 1e-5, 3e-5}}});
  const JointState state = problem.start({{1, -2, 398}, {-3, 4, 403}});
  VectorXd expected = VectorXd::Zero(state.unknowns.size());
  expected.head(6) << 1, -2, -3, 4, 0.5, 2e-5;
  EXPECT_LT((state.unknowns - expected).cwiseAbs().maxCoeff(), 1e-12) << state.unknowns.transpose();
}

// The reference are differences over 1e-4 mm or rad. They err by 1e-9 of the third derivatives, and by the
// rounding of the residuals, some 1e-11 σ: 1e-7 in columns of up to 1e5.
TEST(JointProblem, JacobianIsHowTheResidualsChange) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const JointProblem problem(one.measurement, one.options);
    const JointState state = problem.start(arcsAlone(one.measurement));
    constexpr double step = 1e-4;
    const auto differences = [&](std::size_t v, const auto& move) {
      JointState above = state, below = state;
      move(above, step);
      move(below, -step);
      return VectorXd((problem.equationsOf(below, v).residual - problem.equationsOf(above, v).residual) /
                      (2 * step));
    };
    for (std::size_t v = 0; v < problem.visits().size(); v += 5) {
      const VisitEquations equations = problem.equationsOf(state, v);
      const double small = 1e-6 * equations.jacobian.norm();
      for (Index i = 0; i < state.unknowns.size(); ++i) {
        const Slots slots =
            problem.gathered(VectorXd(VectorXd::Unit(state.unknowns.size(), i)), problem.visits()[v].arc);
        const VectorXd expected =
            differences(v, [&](JointState& moved, double by) { moved.unknowns[i] += by; });
        EXPECT_LT((equations.jacobian * slots - expected).norm(), small) << "visit " << v << ", " << i;
      }
      const VectorXd alongArc =
          differences(v, [&](JointState& moved, double by) { moved.arcAngles[static_cast<Index>(v)] += by; });
      EXPECT_LT((equations.jacobian.col(phiSlot) - alongArc).norm(), small) << "visit " << v;
      EXPECT_LT((equations.along - alongArc.normalized()).norm(), 1e-6) << "visit " << v;
    }
  }
}

// A drift acts by the time since the zero of the position was sighted, next to its first row. A jump acts on
// its row and all later ones. A position whose zero is later is unchanged, because the jump acts on that zero
// too. Zenith readings increase by either. Both are added to the reading itself, so only rounding remains.
TEST(JointProblem, DriftsAndJumpsActByTheRowsPlaceInTime) {
  using enum ErrorTerm;
  const Measurement measurement = test::trialMeasurement("full");
  constexpr std::size_t knocked = 11;
  const JointProblem problem(
      measurement,
      {.terms = {{HorizontalDrift, 1}, {VerticalDrift, 1}, {HorizontalJump, 1}, {VerticalJump, 1}},
       .jumpBefore = measurement.arcs[0].sightings[knocked].order});
  const JointState state = problem.start(arcsAlone(measurement));
  for (std::size_t v = 0; v < problem.visits().size(); ++v) {
    const VisitEquations equations = problem.equationsOf(state, v);
    for (Index row = 0; row < equations.residual.size(); ++row) {
      const ReadingRef cell = problem.cellOf(v, row);
      const std::vector<Sighting>& rows = measurement.arcs[cell.arc].sightings;
      const auto sequence = rows[cell.sighting].sequence;
      const double last = static_cast<double>(measurement.rows - 1);
      const double time = static_cast<double>(sequence) / last,
                   ofZero = static_cast<double>(rows.front().sequence) / last;
      const double jump = cell.arc == 1 || sequence >= knocked ? 1 : 0, jumpOfZero = cell.arc == 1 ? 1 : 0;
      Eigen::Vector4d expected = Eigen::Vector4d::Zero();
      // A zero that was read lower due to the drift was actually higher, and so was the arc that counts from
      // it.
      const double turn = equations.jacobian(row, static_cast<int>(Unknown::Kind::VerticalZero)) *
                          statedSigma(measurement, ReadingKind::Vertical).radians();
      if (cell.kind == ReadingKind::Horizontal) expected << time - ofZero, 0, jump - jumpOfZero, 0;
      if (cell.kind == ReadingKind::Vertical)
        expected << 0, turn * ofZero - time, 0, turn * jumpOfZero - jump;
      const double sigma = statedSigma(measurement, cell.kind).radians();
      EXPECT_LT((equations.jacobian.row(row).tail(4).transpose() * sigma - expected).norm(), 1e-12)
          << sequence;
    }
  }
}

/// All equations in one matrix: unknowns, then an arc angle for each visit; the priors last.
struct Whole {
  MatrixXd jacobian;
  VectorXd residual;
};

Whole wholeOf(const JointProblem& problem, const JointState& state) {
  const std::vector<VisitEquations> all = problem.equationsOf(state);
  const Index count = state.unknowns.size(), visits = state.arcAngles.size();
  Index rows = static_cast<Index>(problem.estimated().size());
  for (const VisitEquations& equations : all) rows += equations.residual.size();
  Whole whole{MatrixXd::Zero(rows, count + visits), VectorXd::Zero(rows)};
  Index row = 0;
  for (std::size_t v = 0; v < all.size(); ++v)
    for (Index i = 0; i < all[v].residual.size(); ++i, ++row) {
      const Slots slots = all[v].jacobian.row(i).transpose();
      whole.jacobian.row(row).head(count) = problem.spread(slots, problem.visits()[v].arc).transpose();
      whole.jacobian(row, count + static_cast<Index>(v)) = slots[phiSlot];
      whole.residual[row] = all[v].residual[i];
    }
  for (std::size_t i = 0; i < problem.estimated().size(); ++i, ++row) {
    if (!std::isfinite(problem.prior(i).sigma)) continue;
    whole.jacobian(row, static_cast<Index>(i)) = 1 / problem.prior(i).sigma;
    whole.residual[row] = -state.unknowns[static_cast<Index>(i)] / problem.prior(i).sigma;
  }
  return whole;
}

// The reference is N and its right side with the arc angles, which are eliminated here by Schur's complement.
// Both sides round at some 1e-16 of the largest products.
TEST(JointProblem, NormalEquationsAreThoseOfAllReadingsAtOnce) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const JointProblem problem(one.measurement, one.options);
    const JointState state = problem.start(arcsAlone(one.measurement));
    const Whole whole = wholeOf(problem, state);
    const JointSystem system = problem.system(state);
    const Index count = state.unknowns.size(), visits = state.arcAngles.size();
    const MatrixXd normal = whole.jacobian.transpose() * whole.jacobian;
    const VectorXd rightSide = whole.jacobian.transpose() * whole.residual;
    const MatrixXd share = normal.topRightCorner(count, visits) *
                           normal.bottomRightCorner(visits, visits).diagonal().cwiseInverse().asDiagonal();
    const MatrixXd expected =
        normal.topLeftCorner(count, count) - share * normal.bottomLeftCorner(visits, count);
    const VectorXd expectedRight = rightSide.head(count) - share * rightSide.tail(visits);
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j)
        EXPECT_NEAR(system.matrix(i, j), expected(i, j), 1e-11 * std::sqrt(normal(i, i) * normal(j, j)));
      EXPECT_NEAR(system.rightSide[i], expectedRight[i],
                  1e-11 * std::sqrt(normal(i, i)) * (1 + whole.residual.norm()));
    }
    EXPECT_NEAR(system.chiSquare, whole.residual.squaredNorm(), 1e-11 * system.chiSquare);
  }
}

// The reference solves all equations at once for the step of unknowns and arc angles. The worst matrix loses
// 1e-7 of it.
TEST(JointProblem, ArcAnglesFollowTheUnknowns) {
  for (const Case& one : cases()) {
    if (one.options.terms.size() > 2) continue;  // the terms cannot all be separated
    SCOPED_TRACE(one.name);
    const JointProblem problem(one.measurement, one.options);
    std::vector<Circle> starts = arcsAlone(one.measurement);
    for (Circle& circle : starts) circle = {circle.x + 0.5, circle.y - 0.3, circle.radius + 0.2};
    const JointState state = problem.start(starts);
    const Whole whole = wholeOf(problem, state);
    const auto estimated = static_cast<Index>(problem.estimated().size());
    MatrixXd free(whole.jacobian.rows(), estimated + state.arcAngles.size());
    free << whole.jacobian.leftCols(estimated), whole.jacobian.rightCols(state.arcAngles.size());
    const VectorXd scale = free.colwise().norm().cwiseInverse();
    const VectorXd step =
        scale.cwiseProduct((free * scale.asDiagonal()).colPivHouseholderQr().solve(whole.residual));
    const JointState moved = problem.moved(state, problem.equationsOf(state), step.head(estimated));
    EXPECT_LT((moved.unknowns.head(estimated) - state.unknowns.head(estimated) - step.head(estimated)).norm(),
              1e-12);
    EXPECT_EQ(moved.unknowns.tail(moved.unknowns.size() - estimated).norm(), 0);
    const VectorXd angles = step.tail(state.arcAngles.size());
    EXPECT_LT((moved.arcAngles - state.arcAngles - angles).norm(), 1e-7 * angles.norm());
  }
}

// Changing a reading by its σ changes its own row by 1 and no other; an excluded one changes none.
TEST(JointProblem, EachRowIsOfTheReadingItNames) {
  const Measurement measurement = test::trialMeasurement("full");
  const JointFitOptions options{.without = {{1, 9, ReadingKind::Vertical}, {0, 4, ReadingKind::Slider}}};
  const JointProblem problem(measurement, options);
  const JointState state = problem.start(arcsAlone(measurement));
  std::size_t silent = 0;
  for (std::size_t v = 0; v < problem.visits().size(); ++v) {
    const VectorXd before = problem.equationsOf(state, v).residual;
    for (Index row = 0; row < before.size(); ++row) {
      const ReadingRef cell = problem.cellOf(v, row);
      Measurement changed = measurement;
      Sighting& sighting = changed.arcs[cell.arc].sightings[cell.sighting];
      if (cell.kind == ReadingKind::Horizontal) sighting.a = sighting.a + measurement.sigmaHorizontal;
      if (cell.kind == ReadingKind::Vertical) sighting.e = sighting.e + measurement.sigmaVertical;
      if (cell.kind == ReadingKind::Slider) sighting.slider = *sighting.slider + measurement.sigmaSlider;
      const VectorXd after = JointProblem(changed, options).equationsOf(state, v).residual;
      const bool takesPart = std::ranges::find(options.without, cell) == options.without.end();
      silent += takesPart ? 0 : 1;
      for (Index other = 0; other < before.size(); ++other)
        EXPECT_NEAR(after[other] - before[other], takesPart && other == row ? 1 : 0, 1e-9) << v << ' ' << row;
    }
  }
  EXPECT_EQ(silent, options.without.size());
}

// At the solution of a fit the gradient of the estimated unknowns is zero, χ² is the fit's, and terms that it
// lacks are zero. The fit stops 1e-9 σ from there.
TEST(JointProblem, TakesUpTheStateOfAFit) {
  for (const Case& one : cases()) {
    if (one.options.terms.size() > 2) continue;
    SCOPED_TRACE(one.name);
    const JointFit fit = fitJointly(one.measurement, arcsAlone(one.measurement), one.options);
    ASSERT_TRUE(fit.converged());
    const JointProblem problem(one.measurement, one.options);
    const JointSystem system = problem.system(problem.stateOf(fit));
    for (Index i = 0; i < static_cast<Index>(problem.estimated().size()); ++i)
      EXPECT_NEAR(system.rightSide[i] / std::sqrt(system.matrix(i, i)), 0, 1e-6);
    EXPECT_NEAR(system.chiSquare, fit.chiSquare, 1e-9 * fit.chiSquare);

    JointFitOptions more = one.options;
    more.terms.push_back({ErrorTerm::GravitySag, 1});
    const JointProblem wider(one.measurement, more);
    const JointState state = wider.stateOf(fit);
    EXPECT_EQ(wider.estimated().back().term, ErrorTerm::GravitySag);
    EXPECT_EQ(state.unknowns[static_cast<Index>(wider.estimated().size()) - 1], 0);
    EXPECT_NEAR(wider.system(state).chiSquare, fit.chiSquare, 1e-9 * fit.chiSquare);
  }
}

}  // namespace
}  // namespace alidade
