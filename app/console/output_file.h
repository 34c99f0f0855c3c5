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

/// Writes the files. None replaces an existing file before the bytes of all are on the disk
/// (`atomic_file.h`). Returns a problem if one cannot be written, is standard output (-), is one of `inputs`,
/// or equals another under any name. Existing files then remain unchanged.
///
/// `inputs`: every file read by the call, - for standard input; empty names, from missing options, are
/// ignored.
std::optional<Problem> writeOutputs(const std::vector<OutputFile>& files, std::vector<std::string> inputs);

}  // namespace alidade::console
