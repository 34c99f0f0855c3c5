#include "core/session/session_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/session/json_text.h"
#include "core/session/session_reader.h"

namespace alidade {

namespace {

constexpr std::size_t largestFile = std::size_t{512} << 20;

/// Reads up to the largest file and one byte more, whatever kind of file it is.
std::string readBounded(std::ifstream& file) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::string text;
  while (file && text.size() <= largestFile) {
    const std::size_t size = text.size();
    text.resize(size + chunk);
    file.read(text.data() + size, chunk);
    text.resize(size + static_cast<std::size_t>(file.gcount()));
  }
  return text;
}

}  // namespace

Result<Session> readSession(std::string_view text) {
  nlohmann::ordered_json json;
  if (auto problem = parseJson(text, json)) return *std::move(problem);
  return sessionFromJson(json);
}

Result<Session> loadSession(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return Problem{"is a folder: choose a session file in it"};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
    return Problem{"cannot be opened (" + std::string(std::strerror(errno)) +
                   "): check its name and your rights"};
  const std::string text = readBounded(file);
  if (file.bad()) return Problem{"cannot be read to its end: check the medium it is on"};
  if (text.size() > largestFile) return Problem{"is larger than 512 MiB: this is no session file"};
  return readSession(text);
}

}  // namespace alidade
