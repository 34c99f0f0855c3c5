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
/// cannot be written, is standard output (-), is one of `inputs`, or is the same as another, whichever way it
/// is named; what stood there before then still does.
///
/// `inputs`: every file that the call reads, - standard input; empty names count for none, as options that
/// are not given.
std::optional<Problem> writeOutputs(const std::vector<OutputFile>& files, std::vector<std::string> inputs);

}  // namespace alidade::console
