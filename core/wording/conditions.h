#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/decision.h"
#include "core/diagnosis/dependence.h"

namespace alidade {

// The conditions of a verdict, in the same words in window, report, certificate, console and JSON.

/// "between the pointing zero and the first sighting at 180°".
std::string momentText(const UndetectableJump& jump);

/// "The verdict holds on the condition that the tripod was not knocked …"; empty without conditions.
/// `decision` was made with `diagnosis`.
std::string conditionSentence(const Diagnosis* diagnosis, const AcceptanceDecision& decision);

/// "The verdict depends on a single row: undecided without 180° point 14."; empty without dependences.
std::string dependenceSentence(const std::vector<Dependence>& dependences);

}  // namespace alidade
