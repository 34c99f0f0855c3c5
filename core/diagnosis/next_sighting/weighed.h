#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "core/diagnosis/next_sighting/overlap.h"
#include "core/diagnosis/next_sighting/sighting_equations.h"

namespace alidade {

/// One of what may be the case after the sightings taken. Without weights: nothing, or larger noise.
struct Weighed {
  std::string_view cause = {};  ///< empty: nothing
  double probability = 0;
  Eigen::Index first = 0;           ///< column of the equations
  Eigen::VectorXd weights = {};     ///< mean, in plausible sizes, over all prior widths
  Eigen::MatrixXd covariance = {};  ///< of the weights
  double noise = 1;                 ///< in stated σ
};

/// The probabilities of what may be the case, each alone, and the readings that it predicts.
///
/// With the unknowns u eliminated, R = 1 − A M⁻¹ Aᵀ, M = AᵀA + prior, the columns C of a cause have the Gram
/// matrix G = Cᵀ R C and the products c = Cᵀ R y. For a prior width w its evidence against nothing is
/// |1 + w² G|^(−1/2) exp(½ cᵀ (w⁻² + G)⁻¹ c), and its weights have the covariance (w⁻² + G)⁻¹.
class WeighedCauses {
 public:
  explicit WeighedCauses(const SightingEquations& equations);

  /// The most likely of each cause with the probability of all of its kind, the most probable first.
  const std::vector<Weighed>& all() const { return m_all; }
  /// ln of the Bayes factor of the mixture of everything that may be the case against nothing, with fixed
  /// prior shares.
  double logEvidence() const { return m_logEvidence; }
  /// χ² after a cause, and its degrees of freedom.
  double chiSquareAfter(const Weighed& cause) const;
  int degreesOfFreedom() const { return m_degreesOfFreedom; }

  /// Predicts the readings of a possible sighting, relative to what nothing predicts.
  class Predictor {
   public:
    Predictor(const WeighedCauses& causes, const SightingRows& rows);
    Prediction under(const Weighed& cause) const;

   private:
    Eigen::MatrixXd m_columns, m_covariance;
  };

 private:
  const SightingEquations& m_equations;
  Eigen::LLT<Eigen::MatrixXd> m_unknowns;  ///< of M
  Eigen::MatrixXd m_eliminated;            ///< L⁻¹ Aᵀ C
  double m_chiSquare = 0, m_logEvidence = 0;
  int m_degreesOfFreedom = 0;
  std::vector<Weighed> m_all;
  Eigen::VectorXd m_right;  ///< L⁻¹ (Aᵀ y + prior)

  Eigen::MatrixXd gramOf(Eigen::Index first, Eigen::Index count) const;
  Eigen::VectorXd productsOf(Eigen::Index first, Eigen::Index count) const;
  double weigh(const MayBe& mayBe, Weighed& weighed) const;
};

}  // namespace alidade
