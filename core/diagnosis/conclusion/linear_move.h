#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The change of Δd by an explanation, in the model linearised at the starting fit, without another fit.
//
// With V the visible columns of its components, W the widths of their weights and r the leftover, the weights
// are w = (VᵀV + W⁻²)⁻¹ Vᵀ r. They change Δd by −bᵀ w, where b is the change of the fit's Δd by the whole
// columns. The variance of Δd grows by bᵀ (VᵀV + W⁻²)⁻¹ b. Of this, bᵀ (VᵀV + W⁻²)⁻¹ VᵀV (VᵀV + W⁻²)⁻¹ b is
// due to the readings and scales with their noise. The rest is due to the prior of the weights.

struct Move {
  double shift = 0;     ///< change of the fit's Δd, mm
  double variance = 0;  ///< of Δd, mm²: of readings (scaled by the leftover) and components, without zeros
};

class LinearMoves {
 public:
  explicit LinearMoves(const Inquiry& inquiry);

  /// Uses the widths of `modelWith`. A pattern does not shift Δd; its possible change of Δd is in the
  /// variance. Absent if a part is not linear, or if the readings do not determine a gross error.
  std::optional<Move> of(const Explanation& explanation);

 private:
  struct Columns {
    Eigen::MatrixXd visible;
    Eigen::VectorXd influence;  ///< change of the fit's Δd, mm
  };

  const Inquiry& m_inquiry;
  Eigen::VectorXd m_perReading;  ///< ∂Δd/∂reading, mm per σ
  double m_ofReadings = 0;       ///< variance of Δd by the readings alone, mm²
  std::map<std::size_t, Columns> m_columns;

  const Columns& columnsOf(const Part& part);
};

}  // namespace alidade
