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

/// The causes with their probabilities, the most probable first: "plane offset (72 %) and axial shift (17
/// %)". Names at most three and counts the others. Larger noise is left out, since U includes it; an unknown
/// cause is named beside known ones. Empty without causes.
std::string causesWithProbability(const Diagnosis& diagnosis);

/// The closures that fail without the causes: "the radii differ by 13 σ, Δx by 7 σ"; empty if none fails.
std::string failedClosures(const Diagnosis& diagnosis);

}  // namespace alidade
