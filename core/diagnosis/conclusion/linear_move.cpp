#include "core/diagnosis/conclusion/linear_move.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/adjustment/result/intersection.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

LinearMoves::LinearMoves(const Inquiry& inquiry)
    : m_inquiry(inquiry), m_perReading(influencePerSigma(inquiry.base)) {}

const LinearMoves::Columns& LinearMoves::columnsOf(const Part& part) {
  const auto [entry, isNew] = m_columns.try_emplace(part.component);
  Columns& columns = entry->second;
  if (!isNew) return columns;
  const Leftover& leftover = m_inquiry.leftover;
  const MatrixXd whole = m_inquiry.of(part).wholeColumns(leftover);
  columns.influence = whole.transpose() * m_perReading;
  columns.visible = leftover.visible(whole);
  return columns;
}

std::optional<Move> LinearMoves::of(const Explanation& explanation) {
  const Leftover& leftover = m_inquiry.leftover;
  MatrixXd visible(leftover.rows(), 0);
  VectorXd influence, narrow;  // 1/width²
  double ofPattern = 0;
  int degreesOfFreedom = leftover.degreesOfFreedom();
  for (const Part& part : explanation.parts) {
    const Component& component = m_inquiry.of(part);
    if (component.isShape()) {
      ofPattern = m_perReading.dot(component.times(leftover, part.weights));
      continue;
    }
    // Such as the other relation of the vertical circle, which is far from its equations at the fit.
    if (component.response() != Response::Linear) return std::nullopt;
    const bool isLeftOut = component.grossErrorAt().has_value();
    const double width = component.widthOfFit(part.width, part.weights);
    const Columns& columns = columnsOf(part);
    const Index before = visible.cols(), more = columns.visible.cols();
    visible.conservativeResize(Eigen::NoChange, before + more);
    visible.rightCols(more) = columns.visible;
    influence.conservativeResize(before + more);
    narrow.conservativeResize(before + more);
    influence.tail(more) = columns.influence;
    narrow.tail(more).setConstant(isLeftOut ? 0 : 1 / (width * width));
    degreesOfFreedom -= isLeftOut ? 1 : 0;
  }

  double chiSquare = leftover.chiSquare();
  // In variances of a reading: however large that is, what no reading shows of a cause stays as uncertain.
  const double ofNoise = explanation.noisy ? explanation.noise * explanation.noise : 1;
  Move move{0, m_perReading.squaredNorm()};
  if (visible.cols() > 0) {
    const VectorXd right = visible.transpose() * leftover.residual();
    MatrixXd matrix = visible.transpose() * visible;
    matrix.diagonal() += ofNoise * narrow;
    const Eigen::LDLT<MatrixXd> factor(matrix);
    const VectorXd weights = factor.solve(right);
    move.shift = -influence.dot(weights);
    move.variance += influence.dot(factor.solve(influence));
    chiSquare -= right.dot(weights);
  }
  if (explanation.shaped) chiSquare = explanation.chiSquare;
  move.variance *= ofNoise * std::pow(noiseScale(chiSquare / ofNoise, degreesOfFreedom).factor, 2);
  move.variance += ofPattern * ofPattern;
  if (!std::isfinite(move.shift) || !std::isfinite(move.variance)) return std::nullopt;
  return move;
}

}  // namespace alidade
