#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace alidade {

struct Measurement;

// Ids of the causes without an error term in the catalogue, and of the one effect that is either present or
// absent. Truth files and results contain them, like the ids of the catalogue.

inline constexpr const char* jumpId = "orientation_jump";
inline constexpr const char* grossErrorId = "gross_error";
inline constexpr const char* noiseId = "underestimated_noise";
inline constexpr const char* relationId = "vertical_angle_relation";  ///< an effect of the catalogue

/// The step of a diagnosis that adds forms to the model. A form is never a cause.
inline constexpr const char* formId = "form";

/// The first step of a diagnosis with known sizes, which adds them to the model. It is not a cause.
inline constexpr const char* knownId = "known_sizes";

/// Every id a diagnosis may name: the effects of the catalogue, a jump, misread values, larger noise.
const std::vector<std::string>& diagnosableEffects();
/// Is `id` one of `diagnosableEffects`, or an effect of the user's own in `measurement`?
bool isDiagnosable(std::string_view id, const Measurement& measurement);

}  // namespace alidade
