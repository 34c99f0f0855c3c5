#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace alidade::test {

/// The sample for every figure of the paper.
inline const std::string paperSession = ALIDADE_SAMPLES_DIR "/paper-table-1.alidade";

inline ProgramRun alidadeCli(std::vector<std::string> arguments) {
  return runProgram({.program = ALIDADE_CLI, .arguments = std::move(arguments)});
}

/// The text of the paper's session after `change`.
std::string changedPaperSession(const std::function<void(nlohmann::ordered_json&)>& change);

/// Exit code 2, nothing on stdout and exactly one line on stderr.
void expectRefusal(const ProgramRun& run);

}  // namespace alidade::test
