#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"

namespace alidade::console {

/// An input of a call for many files, or why it is unusable.
struct ListedFile {
  std::string path;  ///< as opened, and as named in messages; - for standard input
  std::optional<Problem> problem = {};
};

/// The inputs of a call in order. A folder stands for its *.alidade files in the order of their names,
/// without hidden files and subfolders; a series (*.alidade-series) stands for its sessions. A folder that is
/// unreadable or has no session is listed with its problem, and so is a pipe or other special file in a
/// folder. A path to a file that is already listed goes to `again`; hard links count as two files.
struct SessionFiles {
  std::vector<ListedFile> files;
  std::vector<std::string> again;
};
SessionFiles sessionFilesOf(const std::vector<std::string>& named);

/// True for more than one file, for a folder and for a series.
bool namesMany(const std::vector<std::string>& named);

}  // namespace alidade::console
