#include "core/diagnosis/next_sighting/overlap.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace alidade {

namespace {

double logDeterminant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

}  // namespace

double overlapOf(const Prediction& one, const Prediction& other) {
  const Eigen::LLT<Eigen::MatrixXd> mean((one.covariance + other.covariance) / 2), ofOne(one.covariance),
      ofOther(other.covariance);
  const Eigen::VectorXd apart = mean.matrixL().solve(one.mean - other.mean);
  const double distance = apart.squaredNorm() / 8 + logDeterminant(mean) / 2 -
                          (logDeterminant(ofOne) + logDeterminant(ofOther)) / 4;
  return std::clamp(std::exp(-distance), 0.0, 1.0);
}

}  // namespace alidade
