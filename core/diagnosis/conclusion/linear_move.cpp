#include "core/diagnosis/conclusion/linear_move.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/adjustment/result/intersection.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

LinearMoves::LinearMoves(const Inquiry& inquiry)
    : m_inquiry(inquiry),
      m_perReading(influencePerSigma(inquiry.base)),
      m_ofReadings(varianceOfReadings(inquiry.leftover, m_perReading)) {}

const LinearMoves::Columns& LinearMoves::columnsOf(const Part& part) {
  const auto [entry, isNew] = m_columns.try_emplace(part.component);
  Columns& columns = entry->second;
  if (!isNew) return columns;
  const MatrixXd whole = m_inquiry.of(part).wholeColumns(m_inquiry.leftover);
  columns.influence = whole.transpose() * m_perReading;
  columns.visible = m_inquiry.leftover.visible(whole);
  return columns;
}

std::optional<Move> LinearMoves::of(const Explanation& explanation) {
  const Leftover& leftover = m_inquiry.leftover;
  // Variance of the readings. It does not affect the uncertainty of a cause that no reading shows.
  const double ofNoise = explanation.noisy ? explanation.noise * explanation.noise : 1;
  MatrixXd visible(leftover.rows(), 0);
  VectorXd influence, narrow;  // narrow: 1/width²
  int leftOut = 0;             // number of excluded readings
  double ofPattern = 0;
  for (const Part& part : explanation.parts) {
    const Component& component = m_inquiry.of(part);
    if (component.isShape()) {
      ofPattern = m_perReading.dot(component.times(leftover, part.weights));
      continue;
    }
    // Linear equations describe neither bent effects nor all-or-nothing effects.
    if (component.response() != Response::Linear) return std::nullopt;
    const bool isLeftOut = component.grossErrorAt().has_value();
    const double width = component.widthOfFit(part.width, part.weights);
    const Columns& columns = columnsOf(part);
    const Index more = columns.visible.cols(), all = visible.cols() + more;
    visible.conservativeResize(Eigen::NoChange, all);
    visible.rightCols(more) = columns.visible;
    influence.conservativeResize(all);
    narrow.conservativeResize(all);
    influence.tail(more) = columns.influence;
    narrow.tail(more).setConstant(isLeftOut ? 0 : 1 / (width * width));
    leftOut += isLeftOut ? 1 : 0;
  }
  double chiSquare = leftover.chiSquare(), ofReadings = m_ofReadings, ofWidths = 0;
  Move move;
  if (influence.size() > 0) {
    const MatrixXd gram = visible.transpose() * visible;
    const Eigen::LDLT<MatrixXd> factor(gram + MatrixXd(ofNoise * narrow.asDiagonal()));
    const VectorXd right = visible.transpose() * leftover.residual(), weights = factor.solve(right),
                   perWeight = factor.solve(influence);
    move.shift = -influence.dot(weights);
    ofReadings += perWeight.dot(gram * perWeight);
    ofWidths = ofNoise * ofNoise * narrow.dot(perWeight.cwiseAbs2());
    chiSquare -= right.dot(weights);
  }
  if (explanation.shaped) chiSquare = explanation.chiSquare;
  const int degreesOfFreedom = leftover.degreesOfFreedom() - leftOut;
  ofReadings *= ofNoise * std::pow(noiseScale(chiSquare / ofNoise, degreesOfFreedom).factor, 2);
  move.variance = ofReadings + ofWidths + ofPattern * ofPattern;
  if (!std::isfinite(move.shift) || !std::isfinite(move.variance)) return std::nullopt;
  return move;
}

}  // namespace alidade
