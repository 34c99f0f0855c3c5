#pragma once

#include <string>

#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// The verdict of a diagnosis in a few words: "One cause: collimation".
std::string gapInFewWords(const Diagnosis& diagnosis);

/// The causes with their probabilities, the most probable first: "plane offset (72 %) and axial shift (17
/// %)". Names at most three and counts the others. Larger noise is left out, since U includes it; an unknown
/// cause is named beside known ones. Empty without causes.
std::string causesWithProbability(const Diagnosis& diagnosis);

/// The closures that fail without the causes: "the radii differ by 13 σ, Δx by 7 σ"; empty if none fails.
std::string failedClosures(const Diagnosis& diagnosis);

}  // namespace alidade
