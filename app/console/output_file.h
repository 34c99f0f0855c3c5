#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"

namespace alidade::console {

/// A file that an option names, and the whole of what is to stand in it.
struct OutputFile {
  std::string option, path, text;
};

/// Writes the files, none before the bytes of all are on the disk (`atomic_file.h`). The sentence where one
/// cannot be written, is standard output (-), is `input`, or is the same as another, whichever way it is
/// named; what stood there before then still does.
std::optional<Problem> writeOutputs(const std::vector<OutputFile>& files, const std::string& input = {});

}  // namespace alidade::console
