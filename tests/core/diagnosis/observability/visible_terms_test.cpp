#include "core/diagnosis/observability/visible_terms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/candidates/effect_components.h"
#include "core/diagnosis/observability/further_readings.h"
#include "core/diagnosis/observability/look_alikes.h"
#include "core/session/measurement.h"
#include "tests/support/large_session.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Linearised equationsOf(const std::string& protocol) {
  const Measurement measurement = test::trialMeasurement(protocol);
  return linearise(measurement, fitSession(measurement).joint);
}

/// The reference: columns projected with an orthonormal basis. Both lose the digits that the columns' length
/// takes of sixteen.
MatrixXd gramOf(const Leftover& leftover) {
  MatrixXd columns(leftover.readings(), static_cast<Index>(errorTermCount));
  for (Index t = 0; t < columns.cols(); ++t) columns.col(t) = leftover.column(static_cast<ErrorTerm>(t));
  const MatrixXd visible = leftover.visible(columns);
  return visible.transpose() * visible;
}

double greatestError(const VisibleTerms& terms, const MatrixXd& gram) {
  const VectorXd scale = terms.whole.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const MatrixXd error = terms.gram - gram;
  return (scale.asDiagonal() * error * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

constexpr double digits = 1e-11;

TEST(VisibleTerms, AreThoseOfProjectedColumns) {
  for (const char* protocol : {"full", "paper", "two-face"}) {
    const Linearised set = equationsOf(protocol);
    EXPECT_LT(greatestError(visibleTerms(set, everyTerm()), gramOf(Leftover(set))), digits) << protocol;
  }
}

// The columns of a jump are those of a jump before every row, restricted to the rows between its two ends.
TEST(VisibleTerms, HoldJumpsBehindTheTerms) {
  const Linearised set = equationsOf("full");
  const Leftover leftover(set);
  const std::vector<JumpMoment> moments{{5, 40}, {60}};
  const VisibleTerms terms = visibleTerms(set, everyTerm(), moments);
  const auto count = static_cast<Index>(errorTermCount);
  ASSERT_EQ(terms.gram.rows(), count + 4);
  MatrixXd columns(leftover.readings(), 5);
  columns.col(4) = leftover.column(ErrorTerm::GravitySag);
  for (Index m = 0; m < 2; ++m) {
    columns.col(2 * m) = leftover.column(ErrorTerm::HorizontalJump);
    columns.col(2 * m + 1) = leftover.column(ErrorTerm::VerticalJump);
    for (Index i = 0; i < columns.rows(); ++i)
      if (!moments[static_cast<std::size_t>(m)].actsOn(leftover.reading(i).sequence))
        columns.row(i).segment(2 * m, 2).setZero();
  }
  const MatrixXd visible = leftover.visible(columns), gram = visible.transpose() * visible;
  EXPECT_LT((terms.gram.bottomRightCorner(4, 4) - gram.topLeftCorner(4, 4)).cwiseAbs().maxCoeff(),
            1e-9 * gram.topLeftCorner(4, 4).cwiseAbs().maxCoeff());
  const auto sag = static_cast<Index>(ErrorTerm::GravitySag);
  for (Index i = 0; i < 4; ++i)
    EXPECT_NEAR(terms.gram(sag, count + i), gram(4, i), 1e-9 * std::sqrt(gram(4, 4) * gram(i, i)));
}

TEST(VisibleTerms, AddUpOverSetsWithUnknownsOfTheirOwn) {
  const Linearised one = equationsOf("full"), other = equationsOf("paper");
  EXPECT_LT(greatestError(visibleTerms(one, everyTerm()) + visibleTerms(other, everyTerm()),
                          gramOf(Leftover(one)) + gramOf(Leftover(other))),
            digits);
}

// Readings of 60 000 visits come in two pieces with the same unknowns.
TEST(VisibleTerms, AddUpOverThePiecesOfASet) {
  const Session session = test::largeSession(60'000);
  const GapModel model = *modelOf(*examine(session).measurement);
  const std::vector<ErrorTerm> terms{ErrorTerm::Collimation, ErrorTerm::GravitySag,
                                     ErrorTerm::HorizontalDrift};
  VisibleTermsOfSet sum(terms);
  int pieces = 0;
  linearisePlan(model, *model.measurement, terms, [&](const Linearised& piece) {
    sum.add(piece);
    ++pieces;
  });
  EXPECT_EQ(pieces, 2);
  const Linearised whole = linearise(*model.measurement, *model.fit, model.options, terms);
  EXPECT_LT(greatestError(sum.sum(), visibleTerms(whole, terms).gram),
            1e-6);  // the slider is not exactly at one place
}

TEST(VisibleTerms, LoseWhatEstimatedTermsTakeUp) {
  const Linearised set = equationsOf("full");
  const std::vector<EstimatedTerm> estimated{{ErrorTerm::Collimation, 1e-4}, {ErrorTerm::LobingSine, 0.05}};
  EXPECT_LT(greatestError(withEstimated(visibleTerms(set, everyTerm()), estimated),
                          gramOf(Leftover(set, estimated))),
            digits);
}

TEST(VisibleTerms, TellHowFarEffectsAreApart) {
  const Linearised set = equationsOf("full");
  const VisibleTerms terms = visibleTerms(set, everyTerm());
  const Leftover leftover(set);
  const std::vector<EffectComponent> components = effectComponents(leftover, {});
  for (const EffectComponent& one : components) {
    const VectorXd weights = VectorXd::LinSpaced(one.weights(), 1, 2);
    const VectorXd combination = combinationOf(one.effect()) * weights;
    const Trace trace(leftover, one.signature(leftover, weights));
    for (const EffectComponent& other : components) {
      // Its tilt about x turns the zero too, so only rounding errors remain.
      if (other.id() == "vertical_axis_tilt") continue;
      EXPECT_NEAR(linearDifferenceFrom(terms, combination, other.effect()), trace.differenceFrom(other),
                  1e-4 + 2e-5 * trace.differenceFrom(other))
          << one.id() << " from " << other.id();
    }
  }
}

}  // namespace
}  // namespace alidade
