#pragma once

#include <string>
#include <vector>

namespace alidade {

// Ids of the causes that no error term of the catalogue makes up, and of the one effect that is there or not.
// They stand in truth files and in results, like the ids of the catalogue.

inline constexpr const char* jumpId = "orientation_jump";
inline constexpr const char* grossErrorId = "gross_error";
inline constexpr const char* noiseId = "underestimated_noise";
inline constexpr const char* relationId = "vertical_angle_relation";  ///< an effect of the catalogue

/// No cause, but what the session knows beforehand of effects: the first step by which a gap shrinks.
inline constexpr const char* knownId = "known_sizes";

/// Every id a diagnosis may name: the effects of the catalogue, a jump, misread values, larger noise.
const std::vector<std::string>& diagnosableEffects();

}  // namespace alidade
