#include "app/console/output_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace alidade::console {

namespace {

Problem unwritable(const std::string& path) {
  return {path + " cannot be written (" + std::strerror(errno) + "): choose another name or folder"};
}

/// Opens files without touching what is in them; those that are new are taken away again unless `keep` is
/// called.
class Opened {
 public:
  Opened() = default;
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() {
    std::error_code ignored;
    for (const std::string& path : m_new) std::filesystem::remove(path, ignored);
  }

  bool open(const std::string& path) {
    std::error_code ignored;
    const bool isNew = !std::filesystem::exists(path, ignored);
    errno = 0;
    const bool opened = std::ofstream(path, std::ios::binary | std::ios::app).is_open();
    if (opened && isNew) m_new.push_back(std::filesystem::canonical(path, ignored).string());
    return opened;
  }

  void keep() { m_new.clear(); }

 private:
  std::vector<std::string> m_new;
};

}  // namespace

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

std::optional<Problem> writeFiles(const std::vector<OutputFile>& files) {
  Opened opened;
  for (const OutputFile& file : files) {
    if (file.path == "-") return Problem{file.option + " - names no file: give a path to write to"};
    if (!opened.open(file.path)) return unwritable(file.path);
    for (const OutputFile* other = files.data(); other != &file; ++other)
      if (isSameFile(other->path, file.path))
        return Problem{other->option + " and " + file.option + " name the same file: give each its own"};
  }
  opened.keep();
  for (const OutputFile& file : files) {
    errno = 0;
    std::ofstream stream(file.path, std::ios::binary);
    stream << file.text;
    stream.close();
    if (!stream) return unwritable(file.path);
  }
  return std::nullopt;
}

}  // namespace alidade::console
