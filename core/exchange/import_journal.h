#pragma once

#include <string>
#include <vector>

#include "core/exchange/import.h"
#include "core/session/journal.h"

namespace alidade {

/// Line ranges such as `2–18, 20, 22–30`; of more than twenty ranges, the first twenty and the last line.
std::string linesText(const ImportedRows& rows);

/// A file that was imported.
struct ImportedFile {
  std::string name, sha256;  ///< name, and SHA-256 of the file's bytes
};

/// One entry for the rows of each file in each position, without time, operator and hash. It states the lines
/// of the rows in the file, in row order, and the file's SHA-256. `files`: those of the import.
std::vector<JournalEntry> importEntries(const Import& import, const std::vector<ImportedFile>& files);

}  // namespace alidade
