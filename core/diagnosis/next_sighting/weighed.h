#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/next_sighting/sighting_equations.h"

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

/// A hypothesis after the sightings taken. The hypotheses "no cause" and "larger noise" have no weights.
struct Weighed {
  std::string_view cause = {};  ///< empty: no cause
  double probability = 0;
  double logOdds = 0;               ///< ln of the odds of all hypotheses of the cause against no cause
  Eigen::Index first = 0;           ///< first column of the hypothesis
  Eigen::VectorXd weights = {};     ///< mean, in plausible sizes, over all prior widths
  Eigen::MatrixXd covariance = {};  ///< covariance of the weights
  double noise = 1;                 ///< scale of the noise, in stated σ
};

/// The probabilities of the hypotheses, each of one cause alone, and the readings that they predict.
///
/// A are the columns of the unknowns, y the residuals, M = AᵀA + prior, R = 1 − A M⁻¹ Aᵀ. The columns C of a
/// cause have the Gram matrix G = Cᵀ R C and the products c = Cᵀ R y. For a prior width w its evidence is
/// |1 + w² G|^(−1/2) exp(½ cᵀ (w⁻² + G)⁻¹ c), its weights have the covariance (w⁻² + G)⁻¹.
class WeighedCauses {
 public:
  /// `equations` must outlive this object.
  explicit WeighedCauses(const SightingEquations& equations);

  const SightingEquations& equations() const { return m_equations; }
  /// The likeliest hypothesis of each cause, with the total probability of the cause; likeliest cause first.
  const std::vector<Weighed>& all() const { return m_all; }
  /// ln of the Bayes factor of the mixture of all hypotheses, with fixed prior shares, against no cause.
  double logEvidence() const { return m_logEvidence; }
  /// χ² with a cause. `degreesOfFreedom` are those without a cause.
  double chiSquareAfter(const Weighed& cause) const;
  int degreesOfFreedom() const { return m_degreesOfFreedom; }

  /// Predicts the readings of a candidate sighting, relative to the prediction without a cause.
  class Predictor {
   public:
    Predictor(const WeighedCauses& causes, const SightingRows& rows);
    Prediction under(const Weighed& cause) const;

   private:
    Eigen::MatrixXd m_columns, m_covariance;
  };

 private:
  const SightingEquations& m_equations;
  Eigen::LLT<Eigen::MatrixXd> m_unknowns;  ///< Cholesky factor L of M
  Eigen::MatrixXd m_eliminated;            ///< L⁻¹ Aᵀ C
  double m_chiSquare = 0, m_logEvidence = 0;
  int m_degreesOfFreedom = 0;
  std::vector<Weighed> m_all;
  Eigen::VectorXd m_right;  ///< L⁻¹ (Aᵀ y + prior)

  Eigen::MatrixXd gramOf(Eigen::Index first, Eigen::Index count) const;
  Eigen::VectorXd productsOf(Eigen::Index first, Eigen::Index count) const;
  Weighed weigh(const Hypothesis& hypothesis) const;
};

/// The equations with `cause` present for certain. Its size is one more unknown; the prior is centred at the
/// estimate and as wide as the estimate is large. The hypotheses are further causes, without `group`, the
/// causes that no sighting separates from `cause`. A jump or wrong zero excludes all others; a further gross
/// error stays.
SightingEquations withCause(const SightingEquations& equations, const Weighed& cause,
                            const std::vector<std::string>& group);

}  // namespace alidade
