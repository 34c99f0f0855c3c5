#pragma once

#include <vector>

#include "core/exchange/import.h"

namespace alidade {

/// Puts what was read from each file, at least one sighting, into a session. For `importReadings`.
Import assemble(std::vector<Recording> recordings, const std::vector<ReadingsFile>& files,
                const ImportOptions& options);

}  // namespace alidade
