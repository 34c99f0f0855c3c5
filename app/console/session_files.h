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

/// The inputs of a call in order: each file, for each folder its *.alidade files by name, without hidden
/// files and subfolders, and for each series (*.alidade-series) its sessions. An unreadable folder or one
/// without sessions is listed with its problem, like a pipe or other special file in a folder. An input named
/// twice in any way is moved to `again`; hard links count as two files.
struct SessionFiles {
  std::vector<ListedFile> files;
  std::vector<std::string> again;
};
SessionFiles sessionFilesOf(const std::vector<std::string>& named);

/// True for more than one file, for a folder and for a series.
bool namesMany(const std::vector<std::string>& named);

}  // namespace alidade::console
