#include "core/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/base/limits.h"

namespace alidade {

namespace {

/// Reads up to the limit and one byte more.
Result<std::string> readBounded(std::istream& stream, const char* remedy) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string bytes;
  while (stream && bytes.size() <= limits::mostBytes) {
    const std::size_t size = bytes.size();
    bytes.resize(size + chunk);
    stream.read(bytes.data() + size, chunk);
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return Problem{std::string("cannot be read to its end: ") + remedy};
  if (bytes.size() > limits::mostBytes) return limits::tooManyBytes();
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
  return readBounded(file, "check the medium it is on");
}

Result<std::string> readStandardInput() {
  return readBounded(std::cin, "check the program it comes from");
}

}  // namespace alidade
