#pragma once

#include <Eigen/Core>

namespace alidade {

/// A normal distribution of a few readings.
struct Prediction {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// The Bhattacharyya coefficient ∫ √(p q) of two normal distributions, 0…1: 1 if they are equal.
///
/// Source: Kailath, "The divergence and Bhattacharyya distance measures in signal selection", IEEE
/// Transactions on Communication Technology 15 (1967).
double overlapOf(const Prediction& one, const Prediction& other);

}  // namespace alidade
