#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// What an explanation does to Δd in the model linear at the fit it started from, without a fit of its own.
//
// With V the visible columns of its components, W the widths of their weights and r what is left over, the
// weights are w = (VᵀV + W⁻²)⁻¹ Vᵀ r; Δd moves by −bᵀ w, where b is what the columns as a whole move the
// fit's Δd by, and its variance grows by bᵀ (VᵀV + W⁻²)⁻¹ b, of which the readings, whose noise scales, bring
// bᵀ (VᵀV + W⁻²)⁻¹ VᵀV (VᵀV + W⁻²)⁻¹ b, and what is known of the weights the rest.

struct Move {
  double shift = 0;     ///< of the fit's Δd, mm
  double variance = 0;  ///< from readings, scaled by what is left over, and components; no zeros, mm²
  std::vector<double> ofEffects = {};  ///< what is known of each effect besides brings to it, mm²
};

/// Whether every other effect of the catalogue is there as well, as large as it may be (`everyEffect`).
enum class Besides { Nothing, EveryEffect };

class LinearMoves {
 public:
  explicit LinearMoves(const Inquiry& inquiry, Besides besides = Besides::Nothing);

  Besides besides() const { return m_besides; }
  /// What is there besides.
  const std::vector<EstimatedTerm>& effects() const { return m_effects.terms; }

  /// With the widths that `modelWith` takes. A pattern does not shift Δd, what it may move it by is in the
  /// variance. Absent where a part is not linear, or a gross error cannot be told. An effect of the
  /// explanation that would be there besides is as wide as the wider of both.
  std::optional<Move> of(const Explanation& explanation);
  /// Of a known effect (`Component::isKnown`) that holds no longer, besides all that is there with an
  /// explanation: what Δd moves by then, and the natural logarithm of by how much likelier the readings are.
  /// By anything plausible, taken as linear. Absent as above.
  struct Stale {
    Move move;
    double logEvidence = 0;
  };
  std::optional<Stale> ofStale(const Explanation& explanation, std::size_t component);
  /// What the readings say for what is there besides, beside an explanation: the natural logarithm of by how
  /// much likelier they are with it. Absent as above.
  std::optional<double> logEvidenceOfEffects(const Explanation& explanation);

 private:
  struct Columns {
    Eigen::MatrixXd visible;
    Eigen::VectorXd influence;    ///< on the fit's Δd, mm
    Eigen::MatrixXd withEffects;  ///< inner products with the columns of what is there besides
  };
  /// The columns of what is there besides, each for 1σ of what is known of it, by their products.
  struct Effects {
    std::vector<EstimatedTerm> terms;
    Eigen::MatrixXd gram;
    Eigen::VectorXd right, influence, mean;
  };

  /// The normal equations of an explanation with what is there besides, that first.
  struct System {
    Eigen::MatrixXd gram = {};
    Eigen::VectorXd right = {}, influence = {}, narrow = {};  ///< narrow: 1/width²
    double chiSquare = 0;
    /// Variance of the readings: however large that is, what no reading shows of a cause stays as uncertain.
    double ofNoise = 1;
    int leftOut = 0;  ///< readings

    Eigen::MatrixXd matrix() const { return gram + Eigen::MatrixXd(ofNoise * narrow.asDiagonal()); }
  };

  const Inquiry& m_inquiry;
  Besides m_besides;
  Eigen::VectorXd m_perReading;  ///< ∂Δd/∂reading, mm per σ
  double m_ofReadings = 0;       ///< variance of Δd by the readings alone, mm²
  Effects m_effects;
  std::map<std::size_t, Columns> m_columns;

  const Columns& columnsOf(const Part& part);
  void addEffects();
  std::optional<System> systemOf(const Explanation& explanation);
  Move moveOf(const Explanation& explanation, const System& system) const;
  void addLinear(System& system, const Explanation& beside, const Part& part);
  void addPattern(System& system, const Part& part);
  /// It is an effect that is there besides, too, as wide as is plausible.
  bool isBesides(const Component& component) const;
  /// And no larger than that: it adds nothing.
  bool isWhollyBesides(const Part& part) const;
  /// Inner products with each column of what is there besides.
  Eigen::VectorXd productsOfEffects(const Eigen::VectorXd& overReadings) const;
};

}  // namespace alidade
