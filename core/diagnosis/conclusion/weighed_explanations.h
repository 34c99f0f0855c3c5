#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The Δd and the evidence of an explanation together with every effect of the catalogue, in the model
// linearised at one fit.
//
// With V the visible columns of effects, causes and patterns, W the widths of their weights, v the variance
// of the readings and r the leftover, the weights are w = (VᵀV + v W⁻²)⁻¹ Vᵀ r. They change Δd by −bᵀ w,
// where b is the change of the fit's Δd by the whole columns. The evidence is
// |1 + W VᵀV W/v|^(−1/2) exp(½ rᵀV w/v) times that of the noise. If the noise is larger than stated, v is
// that which effects and explanation leave: effects freed by too large a v would cost no evidence.
//
// Source: MacKay, "Bayesian interpolation", Neural Computation 4 (1992); elimination of the explanation's own
// columns by the Schur complement.

/// An explanation together with every effect, whose prior widths are `scales` plausible sizes.
struct WeighedExplanation {
  EffectScales scales;
  double logOdds = 0;   ///< natural logarithm of prior odds × evidence, relative to no cause and no effect
  double value = 0;     ///< Δd, mm
  double variance = 0;  ///< of Δd, mm²: due to readings (scaled by the leftover) and widths, without zeros
  /// The part of the variance due to the weights of explanation and effects, at the noise of the explanation.
  double ofWeights = 0;
  std::vector<double> ofEffects = {};  ///< part of the variance due to the prior of each term, mm²
  double noise = 1;                    ///< likeliest scale of the noise beside the effects
};

class WeighedExplanations {
 public:
  /// Linearises at the inquiry's base.
  explicit WeighedExplanations(const Inquiry& inquiry);
  /// Linearises also at `at`, a fit of the base with `explanation` and every effect at `scales`. Each
  /// explanation then uses the linearisation that makes it likelier, with Δd shifted to agree with that fit.
  /// Does nothing for a large session, or if `at` has larger noise or no Δd.
  void alsoAt(const GapModel& at, const Explanation& explanation, const EffectScales& scales);

  /// The terms of the effects, in the order of `WeighedExplanation::ofEffects`.
  const std::vector<EstimatedTerm>& effects() const { return m_terms; }
  /// One result for each of `possibleScales`, with its probability. Empty if the all-or-nothing effects
  /// of the explanation differ from those in the fit.
  std::vector<WeighedExplanation> of(const Explanation& explanation);
  /// The result with these scales, without their prior probability.
  std::optional<WeighedExplanation> of(const Explanation& explanation, const EffectScales& scales);
  /// Log evidence (natural) for one more component of an explanation, at its plausible size and without
  /// further effects.
  std::optional<double> logEvidenceOf(const Explanation& explanation, const Part& more);
  /// The contribution of the explanation's pattern to each reading, σ.
  Eigen::VectorXd takenByPattern(const Explanation& explanation, const EffectScales& scales);

 private:
  /// The columns of a component whose terms are not in `effects`.
  struct Columns {
    Eigen::MatrixXd whole, visible;
    Eigen::VectorXd right, influence;  ///< products with the leftover; influence on the fit's Δd, mm
    Eigen::MatrixXd withEffects;       ///< inner products with the effects
  };
  struct System;

  const Inquiry& m_inquiry;
  std::optional<Leftover> m_own;              ///< leftover at another fit; absent: the inquiry's leftover
  std::shared_ptr<WeighedExplanations> m_at;  ///< the second linearisation; null: none
  std::vector<ErrorTerm> m_allOrNothing;      ///< all-or-nothing terms in the fit of `m_own`
  double m_start = 0;                         ///< Δd without causes and effects, mm
  Eigen::VectorXd m_perReading;               ///< ∂Δd/∂reading, mm per σ
  double m_ofReadings = 0;                    ///< variance of Δd by the readings alone, mm²
  std::vector<EstimatedTerm> m_terms;         ///< terms of the effects, at their plausible sizes
  std::vector<const Effect*> m_effects;       ///< effect of each term
  Eigen::MatrixXd m_gram;                     ///< Gram matrix of the visible columns of `m_terms`
  Eigen::VectorXd m_right, m_influence;
  std::map<std::size_t, Columns> m_columns;

  const Leftover& leftover() const { return m_own ? *m_own : m_inquiry.leftover; }
  void addEffects();
  Eigen::MatrixXd gramOfColumns() const;
  Eigen::MatrixXd gramOfMany() const;
  const Columns& columnsOf(const Part& part);
  /// At the noise that the explanation has beside effects of plausible size: the search found it without
  /// them.
  std::optional<System> systemOf(const Explanation& explanation);
  std::optional<System> systemOf(const Explanation& explanation, double noise);
  /// `WeighedExplanation::logOdds` of the result is the logarithm of the evidence alone.
  WeighedExplanation weighedAt(const System& system, const EffectScales& scales) const;
  /// Prior widths (1σ) of the effects' weights, in plausible sizes.
  Eigen::VectorXd widthsOf(const System& system, const EffectScales& scales) const;
  Eigen::VectorXd productsOfEffects(const Eigen::VectorXd& overReadings) const;
};

}  // namespace alidade
