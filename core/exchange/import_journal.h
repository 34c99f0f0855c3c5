#pragma once

#include <string>
#include <vector>

#include "core/exchange/import.h"
#include "core/session/journal.h"

namespace alidade {

/// `2–18, 20, 22–30`; of very many runs the first twenty and where the last one ends.
std::string linesText(const ImportedRows& rows);

/// A file that was imported.
struct ImportedFile {
  std::string name, sha256;  ///< of its bytes
};

/// An entry for the rows of each file in each position, without time, operator and hash: from which lines of
/// which file they came, row for row in its order, and its SHA-256. `files`: those of the import.
std::vector<JournalEntry> importEntries(const Import& import, const std::vector<ImportedFile>& files);

}  // namespace alidade
