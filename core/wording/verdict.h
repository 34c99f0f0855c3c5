#pragma once

#include <string>

#include "core/diagnosis/decision.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// The verdict of an acceptance, for a customer. Lengths in mm.

/// What the verdict rests on, or why it is withheld, and how probably |Δd| is within the tolerance; with both
/// accounts of Δd where they belong beside it. `fit`, `diagnosis` (null: none was made) and `decision` are of
/// `measurement`; effects are called as `name` has it.
std::string verdictSentence(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                            const AcceptanceDecision& decision, const CauseNamer& name = byId);

/// Does that sentence tell what lies across the plane of the arc? Not where the verdict is withheld, nor
/// where it is no more than its uncertainty.
bool tellsAcross(const Diagnosis* diagnosis, const AcceptanceDecision& decision);

/// "97.3 %", "more than 99.9 %": of 0…1, within a sentence.
std::string probabilityText(double probability);
/// "97 %", "99.3 %", "> 99.9 %": in a table or a list.
std::string shortProbabilityText(double probability);

/// The decimals of value and U, mm, that show two digits of U, and so many more that the rounded numbers
/// decide against `tolerance` as the numbers themselves do (`decide`).
int decimalsToDecide(double value, double expanded, double tolerance);

/// What `decide` decides, with the numbers it rests on. `expanded` ≥ 0, `tolerance` > 0, `coverage` in (0,
/// 1).
std::string verdictSentence(double value, double expanded, double tolerance, double coverage);

}  // namespace alidade
