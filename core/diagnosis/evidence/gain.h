#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "core/diagnosis/evidence/width.h"

namespace alidade {

// The gain in evidence from one more component of the linear model. G is the Gram matrix of its visible
// columns, c their inner products with the remaining leftover. The weights are normal with mean 0 and width
// w; the readings have the variance v. The component multiplies the evidence by
//
//   |1 + w² G/v|^(−1/2) exp(½ cᵀ (v/w² + G)⁻¹ c/v),        averaged over the widths.

inline constexpr double impossible = -std::numeric_limits<double>::infinity();

/// ln(exp a + exp b).
double logSum(double a, double b);

/// Returns the odds for a difference of two log odds, at most 10⁶; 0 if both are `impossible`.
double oddsOf(double difference);

/// `width` is the most likely width, in plausible sizes. A gain that is not finite comes from columns that
/// are rounding errors, and counts as impossible.
struct Gain {
  Gain() = default;
  Gain(double logGain, double ofWidth) : log(std::isfinite(logGain) ? logGain : impossible), width(ofWidth) {}

  double log = impossible;
  double width = 1;
};

/// Returns the gain of the first component of an explanation. `gram` is G, `right` is c.
Gain gainOf(const std::vector<Width>& widths, const Eigen::MatrixXd& gram, const Eigen::VectorXd& right,
            double variance);

/// A rotation of the columns of a component that makes its Gram matrix tridiagonal. Isotropic normal weights
/// are invariant under rotations.
struct Tridiagonal {
  Eigen::MatrixXd matrix;       ///< columns × matrix are the turned columns; empty: no rotation
  Eigen::VectorXd diagonal;     ///< squared lengths of the turned columns
  Eigen::VectorXd subdiagonal;  ///< inner products of neighbouring columns, one entry fewer
};
Tridiagonal tridiagonalOf(const Eigen::MatrixXd& gram);

/// The turned columns of a component.
struct TurnedColumns {
  Eigen::Ref<const Eigen::VectorXd> diagonal, subdiagonal;  ///< as in `Tridiagonal`
  Eigen::Ref<const Eigen::VectorXd> right;                  ///< inner products with the remaining leftover
  /// Inner products of the turned with the eliminated columns, turned × eliminated. The remaining Gram matrix
  /// is G − shared sharedᵀ. Determinant and inverse of v/w² + G then follow from a small matrix (Woodbury).
  Eigen::Ref<const Eigen::MatrixXd> shared;
};
Gain gainOf(const std::vector<Width>& widths, const TurnedColumns& columns, double variance);

}  // namespace alidade
