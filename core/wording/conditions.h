#pragma once

#include <string>
#include <vector>

#include "core/diagnosis/decision.h"
#include "core/diagnosis/dependence.h"

namespace alidade {

// The conditions of a verdict, in the same words in window, report, certificate, console and JSON.

/// "between the pointing zero and the first sighting at 180°".
std::string momentText(const UndetectableJump& jump);

/// The jump whose absence is a condition of the verdict.
struct ConditionalJump {
  std::string moments;    ///< when it may have happened: "during the readings at 0° or …"
  std::string influence;  ///< the largest change of Δd by a jump of plausible size, in mm: "0.36"
};
/// `decision` was made with `diagnosis` and has conditions.
ConditionalJump jumpConditionOf(const Diagnosis& diagnosis, const AcceptanceDecision& decision);

/// "The verdict holds on the condition that the tripod was not knocked …"; empty without conditions.
/// `decision` was made with `diagnosis`.
std::string conditionSentence(const Diagnosis* diagnosis, const AcceptanceDecision& decision);

/// "The verdict depends on a single row: undecided without 180° point 14."; empty without dependences.
std::string dependenceSentence(const std::vector<Dependence>& dependences);
/// `dependenceSentence` without the full stop.
std::string dependenceText(const std::vector<Dependence>& dependences);

/// Keeps the first three names and replaces the others by their number: "2 others".
std::vector<std::string> namedOrCounted(std::vector<std::string> names);

/// The causes with their probabilities, the most probable first: "plane offset (72 %) and axial shift (17
/// %)". Names at most three and counts the others. Omits larger noise, since U includes it. Adds "an unknown
/// cause" if the catalogue does not explain the gap. Empty without causes.
std::string causesWithProbability(const Diagnosis& diagnosis);

/// "the radii differ by 13 σ, Δx differs by 7.0 σ": the closures that fail without the causes; may be empty.
std::string failedClosures(const Diagnosis& diagnosis);

}  // namespace alidade
