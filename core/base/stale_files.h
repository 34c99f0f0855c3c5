#pragma once

#include <string>

namespace alidade {

/// The ending of our temporary files: `.alidade-4711-1.tmp`, where 4711 is the number of the process.
inline constexpr const char* temporarySuffix = ".tmp";

/// Removes from `folder` temporary files of our programs whose process has ended and that are unchanged for
/// an hour: killed processes leave them. Files that cannot be removed stay.
void clearStaleFiles(const std::string& folder);

}  // namespace alidade
