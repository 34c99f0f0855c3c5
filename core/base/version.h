#pragma once

#include <string>

namespace alidade {

// version.cmake defines these constants in a source file in the build folder.

/// The version in project() of the topmost CMakeLists.txt: "1.0.0".
extern const char* const programVersion;

/// The commit of the build, 12 digits, with "+changes" if files differ from the commit; "archive" for sources
/// without git.
extern const char* const programBuild;

/// "1.0.0 (0123456789ab)".
inline std::string versionAndBuild() {
  return std::string(programVersion) + " (" + programBuild + ")";
}

}  // namespace alidade
