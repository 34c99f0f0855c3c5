#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "core/diagnosis/evidence/width.h"

namespace alidade {

// What one more component adds to the evidence. A component of the linear model whose visible columns have
// the Gram matrix G and the inner products c with what is left, at weights normal around zero with width w
// and readings of variance v, multiplies the evidence by
//
//   |1 + w² G/v|^(−1/2) exp(½ cᵀ (v/w² + G)⁻¹ c/v),        averaged over the widths.

inline constexpr double impossible = -std::numeric_limits<double>::infinity();

/// ln(exp a + exp b).
double logSum(double a, double b);

/// Odds for a difference of two log odds, each of which may be impossible; 10⁶ at most, where what they are
/// counted against weighs nothing any more.
double oddsOf(double difference);

/// `width`: the most likely one, in plausible sizes. What is no finite number, as of columns that rounding
/// has left nothing of, is impossible.
struct Gain {
  Gain() = default;
  Gain(double logGain, double ofWidth) : log(std::isfinite(logGain) ? logGain : impossible), width(ofWidth) {}

  double log = impossible;
  double width = 1;
};

/// `gram` G and `right` c of a component after nothing else.
Gain gainOf(const std::vector<Width>& widths, const Eigen::MatrixXd& gram, const Eigen::VectorXd& right,
            double variance);

/// How to turn the columns of a component so that each has inner products with its neighbours only: its Gram
/// matrix is tridiagonal then. Weights normal around zero look the same in any direction.
struct Tridiagonal {
  Eigen::MatrixXd matrix;       ///< columns × matrix are the turned ones; empty: they stay as they are
  Eigen::VectorXd diagonal;     ///< their squared lengths
  Eigen::VectorXd subdiagonal;  ///< inner products with the next one, one fewer
};
Tridiagonal tridiagonalOf(const Eigen::MatrixXd& gram);

/// The columns of a component, so turned.
struct TurnedColumns {
  Eigen::Ref<const Eigen::VectorXd> diagonal, subdiagonal;  ///< as in `Tridiagonal`
  Eigen::Ref<const Eigen::VectorXd> right;                  ///< inner products with what is left
  /// Their inner products with what was taken off before, columns × taken: G less shared sharedᵀ, so that
  /// determinant and inverse of v/w² + G follow from a matrix as small as what was taken (Woodbury).
  Eigen::Ref<const Eigen::MatrixXd> shared;
};
Gain gainOf(const std::vector<Width>& widths, const TurnedColumns& columns, double variance);

}  // namespace alidade
