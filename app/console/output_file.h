#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"

namespace alidade::console {

/// A file named by an option, with its whole contents.
struct OutputFile {
  std::string option, path, text;
};

/// Writes the files. Existing files are replaced only after the bytes of all new files are on the disk
/// (`atomic_file.h`). Returns a problem if a path cannot be written, is standard output (-), or names the
/// same file as one of `inputs` or another output. Existing files then remain unchanged.
///
/// `inputs`: the paths of all files that the call reads, - for standard input; empty paths are ignored.
std::optional<Problem> writeOutputs(const std::vector<OutputFile>& files, std::vector<std::string> inputs);

}  // namespace alidade::console
