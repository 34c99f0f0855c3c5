#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/evidence/gain.h"

namespace alidade {

// The evidence of a bent component of two weights, second derivatives included.

/// The five weights (x, y, ½x², xy, ½y²) of columns and second derivatives, and their derivatives by x and y.
Eigen::Vector<double, 5> bentWeights(const Eigen::Vector2d& weights);
Eigen::Matrix<double, 5, 2> bentDerivatives(const Eigen::Vector2d& weights);

/// The fit of a bent component: its most likely weights, found on a grid and refined by iteration. `gram` and
/// `right` belong to its two columns and three second derivatives. For widths too narrow for the grid the
/// component counts as linear.
struct BentFit {
  Gain gain;
  Eigen::Vector2d weights;
};
BentFit fitBent(const std::vector<Width>& widths, const Eigen::Matrix<double, 5, 5>& gram,
                const Eigen::Vector<double, 5>& right, double variance);

}  // namespace alidade
