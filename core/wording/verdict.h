#pragma once

#include <string>
#include <utility>

#include "core/diagnosis/decision.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// The verdict of an acceptance, for a customer. Lengths in mm.

/// States the basis of the verdict, or why the verdict is withheld, and the probability of conformity. The
/// basis is Δd, both fit only and measured if `decision.showsBoth`, or the distance from the axis. `fit`,
/// `diagnosis` (may be null) and `decision` belong to `measurement`.
std::string verdictSentence(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                            const AcceptanceDecision& decision);

/// "97.3 %", "more than 99.9 %" for a number in 0…1, within a sentence.
std::string probabilityText(double probability);
/// "97 %", "99.3 %", "> 99.9 %" for a table or a list.
std::string shortProbabilityText(double probability);

/// Returns the decimals for value and U, mm: two digits of U, or as many more as the rounded numbers need for
/// the same decision against `tolerance` (`decide`).
int decimalsToDecide(double value, double expanded, double tolerance);
/// The ends of the interval value ± U, mm, as a reader finds them from the figures rounded to `decimals`.
std::pair<double, double> endsAsWritten(double value, double expanded, int decimals);

/// The verdict of `decide` with its numbers. `expanded` ≥ 0, `tolerance` > 0, `coverage` in (0, 1).
std::string verdictSentence(double value, double expanded, double tolerance, double coverage);

}  // namespace alidade
