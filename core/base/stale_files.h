#pragma once

#include <string>

namespace alidade {

/// How the names of our temporary files end: `.alidade-4711-1.tmp`, where 4711 is the process.
inline constexpr const char* temporarySuffix = ".tmp";

/// Removes from `folder` our own temporary files whose process is gone and that nobody wrote for an hour: a
/// process that was killed left them. What cannot be removed stays.
void clearStaleFiles(const std::string& folder);

}  // namespace alidade
