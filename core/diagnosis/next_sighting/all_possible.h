#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"
#include "core/diagnosis/next_sighting/weighed.h"

namespace alidade {

/// Δd estimated together with the unknowns and every effect of plausible size, as its uncertainty requires.
class IntersectionSoFar {
 public:
  explicit IntersectionSoFar(const SightingEquations& equations);

  double value() const { return m_value; }  ///< mm
  double sigma() const { return std::sqrt(m_variance); }
  /// `sigma()` if the size of this effect were known exactly, mm.
  double sigmaKnowing(const MayBe& effect) const;
  /// −ln(U after/U before) of a possible sighting.
  double tells(const SightingRows& rows) const;

 private:
  Eigen::LLT<Eigen::MatrixXd> m_normal;
  Eigen::VectorXd m_gain;  ///< covariance of the parameters with Δd
  double m_value = 0, m_variance = 0;

  static Eigen::MatrixXd sideBySide(const SightingRows& rows, Eigen::Index effectColumns);
  Eigen::Index m_effectColumns = 0;
};

/// The causes that all sightings, taken and possible, would not separate from `cause`, which comes first. Its
/// trace at its estimated size is nearer than `hardlyDifferent` σ to one of theirs.
std::vector<std::string> inseparableFrom(const Weighed& cause, const SightingEquations& equations);

}  // namespace alidade
