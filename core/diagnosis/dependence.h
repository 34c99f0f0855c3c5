#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "core/diagnosis/decision.h"

namespace alidade {

// The single rows on which a verdict depends: leaving out one of them changes the verdict.
//
// Leaving out row i moves Δd to first order by −Σ g v/(1 − h). v are the residuals of its readings, r their
// redundancies, g = ∂Δd/∂reading. 1 − h = Σ r/c is the share that other rows check. c is the number of
// readings of the row, minus one if its visit has no other row, since one reading then fixes the arc angle.
//
// The diagnosis's choice of an explanation is not linear in the readings. Rows that move Δd most or
// contribute most to χ², Σ (v/σ)²/(1 − h), are therefore left out with a new fit, diagnosis and decision.

/// A row whose exclusion changes the verdict.
struct Dependence {
  std::size_t position = 0, row = 0;  ///< indices in the session
  int axisDeg = 0, repeat = 1, round = 1, point = 0, face = 1;
  Verdict without = Verdict::Undecided;  ///< the verdict without the row
  bool isExact = true;                   ///< false if evaluated to first order only
};

/// At most this number of rows are excluded, each with a new fit and diagnosis.
constexpr std::size_t mostLeftOut = 8;
/// Sessions with more rows are examined to first order only.
constexpr std::size_t mostRowsForLeavingOut = 500;

/// The rows on which `decision` depends, in the order of the session. `decideAcceptance` made `decision` from
/// the other arguments. Empty if the verdict is withheld because of lengths or coverage. On a stop request,
/// returns early with fewer rows.
std::vector<Dependence> dependencesOf(const Measurement& measurement, const SessionFit& fit,
                                      const Diagnosis* diagnosis, const AcceptanceDecision& decision,
                                      const std::stop_token& stop = {});
/// The rows on which the decision of `decideAcceptance` depends; empty without a decision.
std::vector<Dependence> dependencesOf(const Measurement& measurement, const SessionFit& fit,
                                      const Diagnosis* diagnosis, const std::stop_token& stop = {});

}  // namespace alidade
