#include "app/console/channels.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

constexpr char lineEnd = '\n';

}  // namespace

int writeResult(std::string_view result) {
  bool written = true;
  while (written && !result.empty()) {  // line by line, since memory may not hold a second copy
    const std::size_t length = std::min(result.find(lineEnd), result.size() - 1) + 1;
    const std::string line = visibleText(result.substr(0, length), {&lineEnd, 1});
    written = std::fwrite(line.data(), 1, line.size(), stdout) == line.size();
    result.remove_prefix(length);
  }
  if (written && std::fflush(stdout) == 0) return Done;
  notify("alidade-cli", std::string("the result could not be written: ") + std::strerror(errno));
  return Failed;
}

void notify(std::string_view subject, std::string_view message) {
  const std::string line = visibleText(subject) + ": " + visibleText(message) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

ProgressLines::ProgressLines(bool wanted) : m_shown(wanted || isatty(STDERR_FILENO) != 0) {}

bool ProgressLines::isDue() {
  const auto now = std::chrono::steady_clock::now();
  if (!m_shown || now - m_last < std::chrono::seconds(1)) return false;
  m_last = now;
  return true;
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
