#pragma once

#include <cstddef>
#include <span>

namespace alidade {

// All readings of a visit hang on its arc angle φ, which nobody asks for. With the whitened equations
// r − J δ − a δφ of a visit, a = ∂(readings)/∂φ and u = a/|a|, the best δφ leaves
//
//   (1 − u uᵀ)(r − J δ),
//
// so from every column what lies along u is taken off, and φ is gone. In the normal equations that is the
// Schur complement of a block of one number: Jᵀ (1 − u uᵀ) J = JᵀJ − Jᵀa (aᵀa)⁻¹ aᵀJ. Readings that take no
// part have zeros in u and J; where none takes part u is zero and nothing is taken off.
//
// For any matrices of Eigen, row by row at best, so that no linear algebra is included here.

/// Of the equations of one visit, a row for each reading. `along`: u. `share`: as many numbers as there are
/// columns, to work with.
template <typename Rows, typename Along, typename Share>
void eliminateArcAngle(Rows&& rows, const Along& along, Share& share) {
  share.setZero(rows.cols());
  for (std::ptrdiff_t i = 0; i < rows.rows(); ++i) share += along[i] * rows.row(i).transpose();
  for (std::ptrdiff_t i = 0; i < rows.rows(); ++i) rows.row(i) -= along[i] * share.transpose();
}

/// Of one column over the readings of many visits, one visit after the other: visit v ends before reading
/// `endOfVisit[v]`. Both spans hold all readings, `along` the u of each visit.
inline void eliminateArcAngles(std::span<double> column, std::span<const double> along,
                               std::span<const std::ptrdiff_t> endOfVisit) {
  const double* u = along.data();
  double* c = column.data();
  std::ptrdiff_t first = 0;
  for (const std::ptrdiff_t end : endOfVisit) {
    if (end - first == 2) {  // by far the commonest, and too short for a loop
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
