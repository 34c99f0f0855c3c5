#include "app/console/channels.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace alidade::console {

namespace {

std::string oneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace

int writeResult(std::string_view text) {
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return Done;
  std::fprintf(stderr, "alidade-cli: the result could not be written: %s\n", std::strerror(errno));
  return Failed;
}

void notify(std::string_view subject, std::string_view message) {
  const std::string line = oneLine(subject) + ": " + oneLine(message) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

int refuse(std::string_view subject, std::string_view reason) {
  notify(subject, reason);
  return BadInput;
}

std::string inputName(const std::string& file) {
  if (file.empty()) return "the empty file name";
  return file == "-" ? "standard input" : file;
}

}  // namespace alidade::console
