#include "app/console/output_file.h"

#include "core/base/atomic_file.h"
#include "core/base/file_target.h"

namespace alidade::console {

std::optional<Problem> writeOutputs(const std::vector<OutputFile>& files, std::vector<std::string> inputs) {
  std::vector<FileContent> contents;
  for (const OutputFile& file : files) {
    if (file.path == "-") return Problem{file.option + " - names no file: give a path to write to"};
    for (const OutputFile* other = files.data(); other != &file; ++other)
      if (isSameFile(other->path, file.path))
        return Problem{other->option + " and " + file.option + " name the same file: give each its own"};
    contents.push_back({file.path, file.text});
  }
  std::erase(inputs, std::string());
  return writeFiles(contents, inputs);
}

}  // namespace alidade::console
