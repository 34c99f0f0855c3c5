#include "core/base/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/base/limits.h"
#include "core/base/phrase.h"

namespace alidade {

namespace {

/// Reads to the end. Fails above `limits::mostBytes`, and with the sentence `whyBroken` on a read error.
Result<std::string> readBounded(std::istream& stream, const std::string& whyBroken) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string bytes;
  while (stream && bytes.size() <= limits::mostBytes) {
    const std::size_t size = bytes.size();
    bytes.resize(size + chunk);
    stream.read(bytes.data() + size, chunk);
    bytes.resize(size + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return Problem{whyBroken};
  if (bytes.size() > limits::mostBytes) return limits::tooManyBytes();
  return bytes;
}

}  // namespace

Result<std::string> readFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return Problem{Phrase::of("is a folder: choose a file in it")};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    return Problem{//: what the system says is wrong, in parentheses
                   Phrase::of("cannot be opened (%1): check its name and your rights", std::strerror(errno))};
  return readBounded(file, Phrase::of("cannot be read to its end: check the medium it is on"));
}

Result<std::string> readStandardInput() {
  return readBounded(std::cin, "cannot be read to its end: check the program it comes from");
}

}  // namespace alidade
