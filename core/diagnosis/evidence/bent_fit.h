#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/diagnosis/evidence/gain.h"

namespace alidade {

// The evidence of a component of two weights that bends: its second derivatives go along.

/// The five weights (x, y, ½x², xy, ½y²) that columns and second derivatives take, and their derivatives by x
/// and y.
Eigen::Vector<double, 5> bentWeights(const Eigen::Vector2d& weights);
Eigen::Matrix<double, 5, 2> bentDerivatives(const Eigen::Vector2d& weights);

/// Of a bending component with its most likely weights: on a grid over what is plausible, then closing in on
/// the best. `gram` and `right` are of its two columns and three second derivatives. Widths too narrow for
/// the grid are taken as if it did not bend.
struct BentFit {
  Gain gain;
  Eigen::Vector2d weights;
};
BentFit fitBent(const std::vector<Width>& widths, const Eigen::Matrix<double, 5, 5>& gram,
                const Eigen::Vector<double, 5>& right, double variance);

}  // namespace alidade
