#pragma once

#include <string>

namespace alidade {

// Written into the build folder by version.cmake.

/// The version in project() of the topmost CMakeLists.txt: "1.0.0".
extern const char* const programVersion;

/// The commit built from, 12 digits and "+changes" where files differ from it; "archive" for sources without
/// git.
extern const char* const programBuild;

/// "1.0.0 (0123456789ab)".
inline std::string versionAndBuild() {
  return std::string(programVersion) + " (" + programBuild + ")";
}

}  // namespace alidade
