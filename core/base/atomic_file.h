#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/problem.h"

namespace alidade {

/// The system calls for writing a file. Each returns the system's result, including errno; a test can make
/// one fail.
struct FileCalls {
  std::function<int(const char* path, int flags, mode_t mode)> open =
      [](const char* path, int flags, mode_t mode) { return ::open(path, flags, mode); };
  std::function<ssize_t(int file, const void* bytes, std::size_t count)> write = ::write;
  std::function<int(int file, gid_t group)> changeGroup = [](int file, gid_t group) {
    return ::fchown(file, static_cast<uid_t>(-1), group);
  };
  std::function<int(int file)> sync = ::fsync;
  std::function<int(int file)> close = ::close;
  std::function<int(const char* from, const char* to)> rename = std::rename;
};

/// The complete content of a file to be written.
struct FileContent {
  std::string path;
  std::string_view bytes;
  bool isPrivate = false;  ///< a new file is private to its owner
};

/// Writes the file completely or not at all: a temporary file in the same folder receives the bytes and
/// replaces the file once every byte is on the disk. Until then, and if a step fails, the old file stays. A
/// replaced file's permissions are kept, and its group if the system allows it; otherwise the new group gets
/// the rights of all others. The file's other hard links keep the old bytes. A symbolic link stays, and its
/// target is replaced. Terminals, pipes and devices are written to directly. All our programs write files
/// with `writeFile` or `writeFiles`.
///
/// Absent if the file was written; otherwise one sentence with the path, the reason and what to do. `inputs`
/// are the files that were read for the output, `-` for standard input; none of them is replaced, not even
/// through a link. Leave `inputs` empty only if nothing was read. If the folder cannot be synchronised, the
/// new bytes are in place but may not survive a power cut.
[[nodiscard]] std::optional<Problem> writeFile(const std::string& path, std::string_view bytes,
                                               const std::vector<std::string>& inputs,
                                               const FileCalls& calls = {});

/// Writes several files, all or none: the first is replaced only after the bytes of all are on the disk, and
/// if one replacement fails, the others are reverted. If a file cannot be reverted, the sentence names it and
/// the file that contains its old bytes.
[[nodiscard]] std::optional<Problem> writeFiles(const std::vector<FileContent>& files,
                                                const std::vector<std::string>& inputs,
                                                const FileCalls& calls = {});

/// Used by `writeFile`. Copies the access list and the other extended attributes of the file `from` to the
/// open file `to`, if the system allows it. An access list that `to` inherited from its folder is removed.
/// False if `to` lacks the access list of `from`: the group bits of the mode, the list's mask, must then not
/// be copied.
bool copyFileAttributes(const std::string& from, int to);

/// The ending of our temporary files: `.alidade-4711-1.tmp`, where 4711 is the number of the process.
inline constexpr const char* temporarySuffix = ".tmp";

/// Removes from `folder` the temporary files that killed processes of our programs left behind: the process
/// has ended, and the file is unchanged for an hour. Files that cannot be removed stay.
void clearStaleFiles(const std::string& folder);

}  // namespace alidade
