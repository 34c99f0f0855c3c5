#include "core/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace alidade {

namespace {

constexpr std::size_t largestFile = std::size_t{512} << 20;

/// Reads up to the largest file and one byte more.
std::string readBounded(std::ifstream& file) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string bytes;
  while (file && bytes.size() <= largestFile) {
    const std::size_t size = bytes.size();
    bytes.resize(size + chunk);
    file.read(bytes.data() + size, chunk);
    bytes.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  return bytes;
}

}  // namespace

Result<std::string> readFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Problem{"is a folder: choose a file in it"};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    return Problem{"cannot be opened (" + std::string(std::strerror(errno)) +
                   "): check its name and your rights"};
  std::string bytes = readBounded(file);
  if (file.bad()) return Problem{"cannot be read to its end: check the medium it is on"};
  if (bytes.size() > largestFile) return Problem{"is larger than 512 MiB: choose another file"};
  return bytes;
}

}  // namespace alidade
