#pragma once

#include <cstddef>
#include <span>

namespace alidade {

// All readings of a visit depend on its arc angle φ, which is not a result. With the whitened equations
// r − J δ − a δφ of a visit, a = ∂(readings)/∂φ and u = a/|a|, the best δφ leaves
//
//   (1 − u uᵀ)(r − J δ),
//
// so subtracting from every column its component along u eliminates φ. In the normal equations this is the
// Schur complement of a block of one number: Jᵀ (1 − u uᵀ) J = JᵀJ − Jᵀa (aᵀa)⁻¹ aᵀJ. Excluded readings have
// zeros in u and J; if all are excluded u is zero and nothing is subtracted.
//
// For any Eigen matrices, preferably row-major; templates, so that no linear algebra is included here.

/// Eliminates the arc angle from the equations of one visit, a row for each reading. `along` is u. `share` is
/// working memory for one number per column.
template <typename Rows, typename Along, typename Share>
void eliminateArcAngle(Rows&& rows, const Along& along, Share& share) {
  share.setZero(rows.cols());
  for (std::ptrdiff_t i = 0; i < rows.rows(); ++i) share += along[i] * rows.row(i).transpose();
  for (std::ptrdiff_t i = 0; i < rows.rows(); ++i) rows.row(i) -= along[i] * share.transpose();
}

/// Eliminates the arc angles from one column over the readings of many visits in sequence: visit v ends
/// before reading `endOfVisit[v]`. Both spans hold all readings, `along` the u of each visit.
inline void eliminateArcAngles(std::span<double> column, std::span<const double> along,
                               std::span<const std::ptrdiff_t> endOfVisit) {
  const double* u = along.data();
  double* c = column.data();
  std::ptrdiff_t first = 0;
  for (const std::ptrdiff_t end : endOfVisit) {
    if (end - first == 2) {  // by far the most frequent case, and too short for a loop
      const double share = u[first] * c[first] + u[first + 1] * c[first + 1];
      c[first] -= share * u[first];
      c[first + 1] -= share * u[first + 1];
    } else {
      double share = 0;
      for (std::ptrdiff_t i = first; i < end; ++i) share += u[i] * c[i];
      for (std::ptrdiff_t i = first; i < end; ++i) c[i] -= share * u[i];
    }
    first = end;
  }
}

}  // namespace alidade
