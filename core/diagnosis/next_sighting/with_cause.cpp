#include "core/diagnosis/next_sighting/with_cause.h"

#include <algorithm>

#include "core/diagnosis/evidence/bent_fit.h"
#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// ∂(weights of the columns)/∂(unknown sizes): no column for a cause of fixed size.
MatrixXd slopeOf(const Hypothesis& hypothesis, const VectorXd& weights) {
  if (!hypothesis.widths) return MatrixXd::Zero(hypothesis.count, 0);
  if (hypothesis.isBent) return bentDerivatives(weights.head<2>());
  return MatrixXd::Identity(hypothesis.count, hypothesis.count);
}

MatrixXd joined(const MatrixXd& left, const MatrixXd& right) {
  MatrixXd both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

VectorXd stacked(const VectorXd& top, const VectorXd& bottom) {
  VectorXd both(top.size() + bottom.size());
  both << top, bottom;
  return both;
}

}  // namespace

SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group) {
  SightingEquations result = equations;
  const Hypothesis& present = *std::ranges::find(equations.hypotheses, cause.first, &Hypothesis::first);
  const auto columnsIn = [&](const SightingRows& rows) {
    return rows.causes.middleCols(present.first, present.count);
  };
  const MatrixXd slope = slopeOf(present, cause.weights);
  const auto extend = [&](SightingRows& rows) {
    rows.unknowns = joined(rows.unknowns, columnsIn(rows) * slope);
  };
  result.residual -= columnsIn(result.taken) * cause.weights;
  extend(result.taken);
  for (SightingRows& rows : result.possible) extend(rows);
  // The prior is centred at the estimate and as wide as the cause is large, so that the readings decide.
  const Index added = slope.cols();
  const double width = std::max(1.0, cause.weights.head(added).norm());
  result.priorWeights = stacked(result.priorWeights, VectorXd::Constant(added, 1 / width));
  result.priorResiduals = stacked(result.priorResiduals, VectorXd::Zero(added));
  result.intersection = stacked(result.intersection, VectorXd::Zero(added));
  const auto isLeftOut = [&](const Hypothesis& other) {
    if (other.first == present.first) return true;
    return other.cause != grossErrorId && std::ranges::find(group, other.cause) != group.end();
  };
  for (const Hypothesis& other : equations.hypotheses)
    if (isLeftOut(other)) result.priorOdds -= other.priorOdds;
  std::erase_if(result.hypotheses, isLeftOut);
  return result;
}

}  // namespace alidade
