#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/base/finding.h"

namespace alidade {

// Sentences on suspects: readings that look misread.

/// "two digits swapped", "one degree off", …
std::string entryErrorName(EntryError error);

/// Returns: Horizontal 341°52'24" → 341°25'24": two digits swapped; residual then +1.2″.
std::string sentenceOf(const Proposal& proposal);

/// "0°, point 5, vertical"; with round and face unless they are 1.
std::string nameOf(const Suspect& suspect);
/// "off by +59.8″", "the wrong face", "not an angle".
std::string faultOf(const Suspect& suspect);
/// What was most probably meant, or the request to read again.
std::string intentionOf(const Suspect& suspect);

/// Names the reading, its deviation, and the probable intention.
std::string sentenceOf(const Suspect& suspect);

/// One warning that names all suspects; absent without suspects.
std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects);

}  // namespace alidade
