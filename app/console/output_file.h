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

/// Are these two ways to say where one existing file is?
bool isSameFile(const std::string& a, const std::string& b);

/// Writes the files, none before all of them could be opened. The sentence where one cannot be written, is
/// standard output (-) or is the same as another, whichever way it is named; what stood there before then
/// still does.
std::optional<Problem> writeFiles(const std::vector<OutputFile>& files);

}  // namespace alidade::console
