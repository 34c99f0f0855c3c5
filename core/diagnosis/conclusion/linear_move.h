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
};

class LinearMoves {
 public:
  explicit LinearMoves(const Inquiry& inquiry);

  /// With the widths that `modelWith` takes. A pattern does not shift Δd, what it may move it by is in the
  /// variance. Absent where a part is not linear, or a gross error cannot be told.
  std::optional<Move> of(const Explanation& explanation);

 private:
  struct Columns {
    Eigen::MatrixXd visible;
    Eigen::VectorXd influence;  ///< on the fit's Δd, mm
  };

  const Inquiry& m_inquiry;
  Eigen::VectorXd m_perReading;  ///< ∂Δd/∂reading, mm per σ
  double m_ofReadings = 0;       ///< variance of Δd by the readings alone, mm²
  std::map<std::size_t, Columns> m_columns;

  const Columns& columnsOf(const Part& part);
};

}  // namespace alidade
