#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "core/base/result.h"

namespace alidade {

/// Where bytes written under a name come to stand.
struct FileTarget {
  enum class Kind {
    New,     ///< nothing is there yet
    File,    ///< a regular file, to be replaced
    Direct,  ///< a terminal, pipe or device such as /dev/null: written to, never replaced
  };

  std::string path;  ///< with the links of the name followed: the link stays, what it leads to is replaced
  Kind kind = Kind::New;
  mode_t mode = 0;  ///< of `File`: its permissions
  uid_t owner = 0;  ///< of `File`
  gid_t group = 0;  ///< of `File`
  std::optional<int> descriptor =
      {};  ///< of `Direct`: an open file of this process, as /dev/stdout names one

  std::string folder() const;  ///< that `path` is in
};

/// Follows `path`. The sentence names the trouble, not the file: a folder stands there, the file is
/// read-only, its folder is gone, and so on.
Result<FileTarget> fileTarget(const std::string& path);

/// Why a file cannot be written, and what to do, from the system's error number: "the disk is full: make room
/// there or choose another folder".
std::string whyUnwritable(int error);

/// Are these two names of one regular file, there or still to be made? Links, hard ones too, and roundabout
/// ways count as the same.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace alidade
