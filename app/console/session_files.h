#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"

namespace alidade::console {

/// An input of a call that takes many, or why there is none.
struct ListedFile {
  std::string path;  ///< as it is to be opened, and as messages call it; - for standard input
  std::optional<Problem> problem = {};
};

/// What the call names, in its order: a file stands for itself, a folder for the *.alidade in it, by name,
/// hidden ones and those of further folders left out. A folder that cannot be read or holds no session is
/// listed with its problem, and so is what a folder holds that is no file, such as a pipe. What is named
/// again, whichever way, is left out and goes to `again`; two names of one file that are no links to each
/// other (hard links) are two.
struct SessionFiles {
  std::vector<ListedFile> files;
  std::vector<std::string> again;
};
SessionFiles sessionFilesOf(const std::vector<std::string>& named);

/// More than one file, or a folder: an answer to each.
bool namesMany(const std::vector<std::string>& named);

}  // namespace alidade::console
