#pragma once

#include <vector>

#include "core/exchange/import.h"

namespace alidade {

/// Combines the recordings of the files, with at least one sighting each, into a session. Used by
/// `importReadings`.
Import assemble(std::vector<Recording> recordings, const std::vector<ReadingsFile>& files,
                const ImportOptions& options);

}  // namespace alidade
