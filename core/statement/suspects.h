#pragma once

#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/statement/statement.h"

namespace alidade {

/// The readings that look misread, the most certain first: each with its deviation and the probable
/// intention, other intentions as parts.
Statement suspectTable(const std::vector<Suspect>& suspects);

}  // namespace alidade
