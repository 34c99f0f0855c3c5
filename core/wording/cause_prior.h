#pragma once

#include <string>

namespace alidade {

/// Returns the plausible size (1σ) of a catalogue effect: "30″", "0.05 mm"; pure numbers have no unit.
/// Empty for a jump, misread values and larger noise, which have no plausible size.
std::string plausibleSizeText(const std::string& id);

}  // namespace alidade
