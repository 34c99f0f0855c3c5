#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/diagnosis/gap/every_effect.h"
#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// What an explanation does to Δd where every effect of the catalogue is there besides, in the model linear at
// one fit, and how likely the readings are then.
//
// With V the visible columns of effects, causes and patterns, W the widths of their weights, v the variance
// of the readings and r what is left over, the weights are w = (VᵀV + v W⁻²)⁻¹ Vᵀ r. Δd moves by −bᵀ w, where
// b is what the whole columns move the fit's Δd by. The evidence is |1 + W VᵀV W/v|^(−1/2) exp(½ rᵀV w/v)
// times that of the noise.
//
// Source: MacKay, "Bayesian interpolation", Neural Computation 4 (1992); elimination of the explanation's own
// columns by the Schur complement.

/// An explanation with every effect besides, so many plausible sizes wide.
struct Account {
  EffectScales scales;
  double logOdds = 0;   ///< prior and evidence, against nothing at all and no effect besides; natural
  double value = 0;     ///< of Δd, mm
  double variance = 0;  ///< from the readings, scaled by what is left over, and from widths; no zeros, mm²
  /// That of the explanation's weights and the effects alone, with the noise as it is believed.
  double ofWeights = 0;
  std::vector<double> ofEffects = {};  ///< what is known of each effect brings to the variance, mm²
};

class Accounts {
 public:
  /// Linear at the inquiry's base.
  explicit Accounts(const Inquiry& inquiry);
  /// And at a fit of the base with an explanation and every effect, so many plausible sizes wide, wherever
  /// that is the likelier of both; values count from there. Not of a large session.
  void alsoAt(const GapModel& at, const Explanation& explanation, const EffectScales& scales);

  /// The terms of the effects besides, as `Account::ofEffects` has them.
  const std::vector<EstimatedTerm>& effects() const { return m_terms; }
  /// One for each of `possibleScales`, with their probabilities. Empty where what is there or not at all
  /// differs from that in the fit.
  std::vector<Account> of(const Explanation& explanation);
  /// The same for scales of one's own, taken as certain.
  std::optional<Account> of(const Explanation& explanation, const EffectScales& scales);
  /// What the readings say for one more component beside an explanation, at its plausible size and with no
  /// effect besides: natural logarithm.
  std::optional<double> logEvidenceOf(const Explanation& explanation, const Part& more);
  /// What its pattern takes up of each reading, σ.
  Eigen::VectorXd takenByPattern(const Explanation& explanation, const EffectScales& scales);

 private:
  /// Of a component that is no effect of the catalogue.
  struct Columns {
    Eigen::MatrixXd whole, visible;
    Eigen::VectorXd right, influence;  ///< products with what is left over; on the fit's Δd, mm
    Eigen::MatrixXd withEffects;       ///< inner products with the effects
  };
  struct System;

  const Inquiry& m_inquiry;
  std::optional<Leftover> m_own;         ///< at a fit of one's own
  std::shared_ptr<Accounts> m_at;        ///< linear there
  std::vector<ErrorTerm> m_settled;      ///< there or not at all: those that are
  double m_start = 0;                    ///< Δd without causes and effects, mm
  Eigen::VectorXd m_perReading;          ///< ∂Δd/∂reading, mm per σ
  double m_ofReadings = 0;               ///< variance of Δd by the readings alone, mm²
  std::vector<EstimatedTerm> m_terms;    ///< of the effects, at their plausible sizes
  std::vector<const Effect*> m_effects;  ///< of each term
  Eigen::MatrixXd m_gram;                ///< of their visible columns for plausible sizes
  Eigen::VectorXd m_right, m_influence;
  std::map<std::size_t, Columns> m_columns;

  const Leftover& leftover() const { return m_own ? *m_own : m_inquiry.leftover; }
  void addEffects();
  Eigen::MatrixXd gramOfColumns() const;
  Eigen::MatrixXd gramOfMany() const;
  const Columns& columnsOf(const Part& part);
  std::optional<System> systemOf(const Explanation& explanation);
  /// `logOdds`: logarithm of the evidence alone.
  Account accountOf(const System& system, const EffectScales& scales) const;
  /// Of the effects' weights in plausible sizes: 1σ of each.
  Eigen::VectorXd widthsOf(const System& system, const EffectScales& scales) const;
  Eigen::VectorXd productsOfEffects(const Eigen::VectorXd& overReadings) const;
};

}  // namespace alidade
