#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "core/base/result.h"

namespace alidade {

/// The destination of bytes written under a name.
struct FileTarget {
  enum class Kind {
    New,     ///< does not exist yet
    File,    ///< a regular file, to be replaced
    Direct,  ///< a terminal, pipe or device such as /dev/null: written to, never replaced
  };

  std::string path;  ///< path with links resolved: a link stays, its target is replaced
  Kind kind = Kind::New;
  mode_t mode = 0;                     ///< permissions of a `File`
  uid_t owner = 0;                     ///< user id of a `File`
  gid_t group = 0;                     ///< group id of a `File`
  std::optional<int> descriptor = {};  ///< open file that a `Direct` such as /dev/stdout names

  std::string folder() const;  ///< the folder of `path`
};

/// Resolves `path`. The problem describes the trouble without the file's name: it is a folder, the file is
/// read-only, its folder is missing, and so on.
Result<FileTarget> fileTarget(const std::string& path);

/// Returns the reason why a file cannot be written, and the remedy, from the system's error number. Example:
/// "the disk is full: make room there or choose another folder".
std::string whyUnwritable(int error);

/// Do these two names denote one regular file, existing or new? Links, hard ones too, and indirect paths are
/// resolved.
bool isSameFile(const std::string& a, const std::string& b);

}  // namespace alidade
