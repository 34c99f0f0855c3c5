#include "app/console/channels.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

constexpr std::string_view lineEnd = "\n";

}  // namespace

int writeResult(std::string_view result) {
  const std::string text = visibleText(result, lineEnd);
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return Done;
  notify("alidade-cli", std::string("the result could not be written: ") + std::strerror(errno));
  return Failed;
}

void notify(std::string_view subject, std::string_view message) {
  const std::string line = visibleText(subject) + ": " + visibleText(message) + "\n";
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
