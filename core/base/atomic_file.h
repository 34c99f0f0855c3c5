#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file_calls.h"
#include "core/base/problem.h"

namespace alidade {

/// The whole of what is to stand in a file.
struct FileContent {
  std::string path;
  std::string_view bytes;
  bool isPrivate = false;  ///< a file that is new is for its owner alone
};

/// Writes the file, all of it or nothing: into a temporary file in the same folder, which takes the file's
/// place once every byte is on the disk. Until then, and wherever a step fails, what stood there stays. The
/// permissions of a file that is replaced are kept, its group where that is allowed; its other hard links
/// keep the old bytes. A link stays, and what it leads to is replaced. Terminals, pipes and devices are
/// written to directly. Every program of ours writes by this.
///
/// Absent: written. Otherwise one sentence with the path, the reason and what to do. Refuses to replace one
/// of `inputs`, all files that were read for what is written, however it is named; `-` among them is
/// standard input. Empty only where nothing was read. After a folder that cannot be synchronised the new
/// bytes are there, but may not outlast a power cut.
[[nodiscard]] std::optional<Problem> writeFile(const std::string& path, std::string_view bytes,
                                               const std::vector<std::string>& inputs,
                                               const FileCalls& calls = {});

/// Likewise several, all or none: none is replaced before the bytes of all are on the disk, and where one
/// cannot take its place, those that did go back. Where even that fails, the sentence says which file is the
/// new one and where its old bytes are.
[[nodiscard]] std::optional<Problem> writeFiles(const std::vector<FileContent>& files,
                                                const std::vector<std::string>& inputs,
                                                const FileCalls& calls = {});

}  // namespace alidade
