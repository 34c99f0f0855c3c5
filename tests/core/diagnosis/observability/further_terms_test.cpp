#include "core/diagnosis/observability/further_terms.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <iterator>
#include <utility>
#include <vector>

#include "tests/support/full_leftover.h"
#include "tests/support/linearised_plan.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using test::greatest;

const std::vector<const Effect*>& someEffects() {
  static const std::vector<const Effect*> effects{effectById("vertical_drift"), effectById("plane_warp"),
                                                  effectById("collimation"), effectById("vertical_drift")};
  return effects;
}

/// The visible parts of every term in a set, from columns projected on the complement of what its fit
/// absorbs.
MatrixXd shownBy(const Linearised& set) {
  const Leftover leftover(set);
  MatrixXd columns(leftover.readings(), static_cast<Index>(errorTermCount));
  for (Index t = 0; t < columns.cols(); ++t) columns.col(t) = leftover.column(static_cast<ErrorTerm>(t));
  return leftover.visible(columns);
}

MatrixXd below(const MatrixXd& one, const MatrixXd& other) {
  MatrixXd all(one.rows() + other.rows(), one.cols());
  all << one, other;
  return all;
}

/// The visible parts with the estimated terms of the model eliminated, including their prior knowledge.
MatrixXd withoutEstimated(const MatrixXd& columns, const std::vector<EstimatedTerm>& estimated) {
  const Index count = std::ssize(estimated), rows = columns.rows();
  if (count == 0) return columns;
  MatrixXd all = below(columns, MatrixXd::Zero(count, columns.cols()));
  MatrixXd taken = MatrixXd::Zero(rows + count, count);
  for (Index i = 0; i < count; ++i) {
    const EstimatedTerm& term = estimated[static_cast<std::size_t>(i)];
    taken.col(i).head(rows) = columns.col(static_cast<Index>(term.term));
    taken(rows + i, i) = 1 / term.priorSigma;
  }
  return all - taken * taken.colPivHouseholderQr().solve(all);
}

/// Compares some terms, each relative to its full length; the others must be zero.
void expectShown(const VisibleTerms& shown, const MatrixXd& columns, const std::vector<ErrorTerm>& terms) {
  MatrixXd expected = MatrixXd::Zero(columns.cols(), columns.cols());
  const MatrixXd gram = columns.transpose() * columns;
  for (const ErrorTerm a : terms)
    for (const ErrorTerm b : terms)
      expected(static_cast<Index>(a), static_cast<Index>(b)) =
          gram(static_cast<Index>(a), static_cast<Index>(b));
  for (Index t = 0; t < columns.cols(); ++t) EXPECT_EQ(shown.whole[t] > 0, expected(t, t) > 0) << t;
  const VectorXd scale = shown.whole.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  EXPECT_LT(greatest(scale.asDiagonal() * (shown.gram - expected) * scale.asDiagonal()), 1e-10);
}

/// Returns models as in a diagnosis: with effects of the session's own model, and with excluded readings.
GapModel modelWith(const std::vector<EstimatedTerm>& terms, const std::vector<ReadingRef>& without) {
  GapModel model = *modelOf(test::trialMeasurement("paper-slider"));
  model.options.terms = terms;
  model.options.without = without;
  model.refit();
  return model;
}

// The reference uses columns and an orthonormal basis, the code normal equations. Both lose the digits that
// the columns' length takes of sixteen. Further readings add to what the session shows, each set with its own
// circles and zeros. A session as read uses its own equations, otherwise those of its plan.
TEST(FurtherTerms, AreThoseOfAllSetsTogether) {
  const std::vector<EstimatedTerm> some{{ErrorTerm::TrunnionTilt, 1e-5}, {ErrorTerm::LobingSine, 0.05}};
  const std::vector<ErrorTerm> requested{ErrorTerm::VerticalDrift, ErrorTerm::WarpCosine, ErrorTerm::WarpSine,
                                         ErrorTerm::Collimation};
  for (const auto& [terms, without] :
       {std::pair<std::vector<EstimatedTerm>, std::vector<ReadingRef>>{{}, {}},
        {some, {}},
        {{}, {{0, 4, ReadingKind::Vertical}, {1, 9, ReadingKind::Horizontal}}}}) {
    const GapModel model = modelWith(terms, without);
    const Linearised ofSession = linearise(*model.measurement, *model.fit, model.options);
    const bool asRead = terms.empty() && without.empty();
    std::vector<ErrorTerm> known = requested;
    for (const EstimatedTerm& term : terms) known.push_back(term.term);
    FurtherTerms further(model, ofSession, someEffects());
    int withSession = 0;
    eachFurtherReadings(model, [&, &terms = terms](const FurtherReadings& plan) {
      SCOPED_TRACE(static_cast<int>(plan.measures.front()));
      MatrixXd columns = shownBy(test::linearisedPlan(model, plan.sets.back()));
      if (plan.includesSession)
        columns =
            below(columns, shownBy(asRead ? ofSession : test::linearisedPlan(model, plan.sets.front())));
      withSession += plan.includesSession;
      const VisibleTerms shown = further.shownBy(plan);
      expectShown(shown, withoutEstimated(columns, terms), known);
      EXPECT_EQ(further.shownBy(plan).gram, shown.gram);  // a repeated call
    });
    EXPECT_EQ(withSession, 2);
  }
}

// Twice the readings of a session with an unchanged circle show twice the squares. In the second set the
// circle is turned, which affects only an eccentricity.
TEST(FurtherTerms, OfAShiftedCircleAreTwiceThoseOfTheSession) {
  const GapModel model = *modelOf(readWithoutError(*modelOf(test::trialMeasurement("full"))));
  const Linearised ofSession = linearise(*model.measurement, *model.fit);
  FurtherTerms further(model, ofSession, someEffects());
  const MatrixXd columns = shownBy(ofSession);
  eachFurtherReadings(model, [&](const FurtherReadings& plan) {
    if (plan.measures.front() != Measure::ShiftedCircle) return;
    const VisibleTerms shown = further.shownBy(plan);
    for (const ErrorTerm term : {ErrorTerm::VerticalDrift, ErrorTerm::Collimation, ErrorTerm::WarpSine}) {
      const auto t = static_cast<Index>(term);
      const double once = columns.col(t).squaredNorm();
      EXPECT_NEAR(shown.gram(t, t) / once, 2, 1e-6) << t;
    }
  });
}

}  // namespace
}  // namespace alidade
