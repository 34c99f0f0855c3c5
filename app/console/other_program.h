#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace alidade::console {

/// The result of a finished program.
struct ProgramEnd {
  int exitCode = 0;    ///< 128 + signal if a signal ended the program
  std::string errors;  ///< what the program wrote to stderr
};

/// The path of the executable `name` in the folder of this program. Fails if there is no such executable.
Result<std::string> installedProgram(const std::string& name);

/// Runs a program to its end without input; its stdout is dropped. Fails if it cannot be started.
Result<ProgramEnd> runToEnd(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace alidade::console
