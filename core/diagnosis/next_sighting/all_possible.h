#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {

/// Δd, estimated with the unknowns and every effect. The prior σ of an effect is at most its plausible size.
class IntersectionSoFar {
 public:
  explicit IntersectionSoFar(const SightingEquations& equations);

  double value() const { return m_value; }  ///< mm
  double sigma() const { return std::sqrt(m_variance); }
  /// `sigma()` if the size of this effect were known exactly, mm.
  double sigmaKnowing(const Hypothesis& effect) const;
  /// Returns −ln(U after/U before), where U is that of Δd, for a possible sighting.
  double logReductionBy(const SightingRows& rows) const;

 private:
  Eigen::LLT<Eigen::MatrixXd> m_normal;
  Eigen::VectorXd m_gain;  ///< covariance of the parameters with Δd
  double m_value = 0, m_variance = 0;
  Eigen::Index m_effectColumns = 0;
};

/// Returns `cause`, then the causes that all sightings, taken and possible, would not separate from `cause`.
/// Each of these has a trace closer than `hardlyDifferent` σ to that of `cause` at its estimated size.
std::vector<std::string> inseparableFrom(const Weighed& cause, const SightingEquations& equations);

}  // namespace alidade
