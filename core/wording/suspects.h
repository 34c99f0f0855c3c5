#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/base/finding.h"

namespace alidade {

// Sentences on suspects: readings that look misread.

/// "two digits swapped", "one degree off", …
std::string slipName(EntrySlip slip);

/// Horizontal 341°52'24" → 341°25'24": two digits swapped; residual then +1.2″.
std::string sentenceOf(const Proposal& proposal);

/// Names the reading, its deviation, and the probable intention.
std::string sentenceOf(const Suspect& suspect);

/// One warning that names all suspects; absent without suspects.
std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects);

}  // namespace alidade
