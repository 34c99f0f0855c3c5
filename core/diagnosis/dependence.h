#pragma once

#include <cstddef>
#include <vector>

#include "core/diagnosis/decision.h"

namespace alidade {

// On which single rows a verdict depends: leaving out one of them makes another verdict of it.
//
// Leaving out row i, with residuals v, redundancies r and ∂Δd/∂reading g of its readings, moves Δd to first
// order by −Σ g v/(1 − h), where 1 − h = Σ r/c is what the other rows check of it: c of its readings are
// conditions, all but the one that fixes the arc angle of a visit of this row alone. Which explanation the
// diagnosis prefers is not linear in the readings. So the rows that move Δd most, and those that bring most
// to χ², Σ (v/σ)²/(1 − h), are left out in earnest: fit, diagnosis and decision anew.

/// A row without which the verdict would be another one.
struct Dependence {
  std::size_t position = 0, row = 0;  ///< of the session
  int axisDeg = 0, time = 1, round = 1, point = 0, face = 1;
  Verdict without = Verdict::Undecided;  ///< the verdict then
  bool isExact = true;                   ///< else to first order
};

/// At most so many rows are left out in earnest: each costs a fit and a diagnosis.
constexpr std::size_t mostLeftOut = 8;
/// In longer sessions none is: what moves Δd across a limit to first order is told.
constexpr std::size_t mostRowsForLeavingOut = 500;

/// In the order of the session. Arguments as in `decideAcceptance`, which made `decision` of them. None where
/// the verdict is withheld for the lengths or the coverage.
std::vector<Dependence> dependencesOf(const Measurement& measurement, const SessionFit& fit,
                                      const Diagnosis* diagnosis, const AcceptanceDecision& decision);

}  // namespace alidade
