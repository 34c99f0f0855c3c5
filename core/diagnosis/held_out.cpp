#include "core/diagnosis/held_out.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <set>

namespace alidade {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::size_t folds = 5;

/// Everything a prediction needs: what the fit takes up, then the causes, and the observations.
struct Equations {
  MatrixXd columns;
  VectorXd observed, weights;  ///< `weights`: inverse prior variances
  std::set<Index> without;     ///< readings blamed
};

Equations equationsOf(const Leftover& leftover, const Explanation* explanation,
                      const std::vector<Component>& candidates) {
  Equations equations;
  equations.columns = leftover.base();
  equations.observed = leftover.observed();
  equations.weights = VectorXd::Zero(equations.columns.cols());
  if (!explanation) return equations;
  for (const Part& part : explanation->parts) {
    if (part.component >= candidates.size()) {
      equations.without.insert(static_cast<Index>(part.component - candidates.size()));
      continue;
    }
    const Component& component = candidates[part.component];
    // One column: the cause as found, its size left free. Visible parts serve, since what they lack is
    // what the fit takes up.
    const VectorXd trace = signature(leftover, component, part.weights);
    const Index last = equations.columns.cols();
    equations.columns.conservativeResize(Eigen::NoChange, last + 1);
    equations.columns.col(last) = trace;
    equations.weights.conservativeResize(last + 1);
    const double size = part.weights.norm() / part.width;
    equations.weights[last] = size * size;
  }
  return equations;
}

/// Sum of squares of the predicted readings' errors, arcseconds.
double predictionSquares(const Leftover& leftover, const Equations& equations,
                         const std::set<Index>& uncounted) {
  double sum = 0;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const auto kept = [&](Index i) {
      return i >= leftover.readings() || leftover.reading(i).visit % folds != fold;
    };
    MatrixXd train = equations.columns;
    VectorXd observed = equations.observed;
    for (Index i = 0; i < train.rows(); ++i)
      if (!kept(i) || equations.without.count(i)) {
        train.row(i).setZero();
        observed[i] = 0;
      }
    MatrixXd normal = train.transpose() * train;
    normal.diagonal() += equations.weights;
    normal.diagonal().array() += 1e-12;
    const VectorXd solution = normal.ldlt().solve(train.transpose() * observed);
    const VectorXd errors = equations.observed - equations.columns * solution;
    for (Index i = 0; i < leftover.readings(); ++i) {
      const LinearReading& reading = leftover.reading(i);
      if (kept(i) || uncounted.count(i) || reading.kind == ReadingKind::Slider) continue;
      sum += std::pow(errors[i] * Angle::fromRadians(reading.sigma).arcseconds(), 2);
    }
  }
  return sum;
}

}  // namespace

double heldOutShrinkage(const Leftover& leftover, const Explanation& explanation,
                        const std::vector<Component>& candidates) {
  const Equations before = equationsOf(leftover, nullptr, candidates);
  const Equations after = equationsOf(leftover, &explanation, candidates);
  const double squaresBefore = predictionSquares(leftover, before, {});
  const double squaresAfter = predictionSquares(leftover, after, after.without);
  return squaresBefore > 0 ? 1 - std::sqrt(squaresAfter / squaresBefore) : 0;
}

}  // namespace alidade
