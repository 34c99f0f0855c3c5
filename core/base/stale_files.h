#pragma once

#include <string>

namespace alidade {

/// The ending of our temporary files: `.alidade-4711-1.tmp`, where 4711 is the number of the process.
inline constexpr const char* temporarySuffix = ".tmp";

/// Removes from `folder` the temporary files that killed processes of our programs left behind: the process
/// has ended, and the file is unchanged for an hour. Files that cannot be removed stay.
void clearStaleFiles(const std::string& folder);

}  // namespace alidade
