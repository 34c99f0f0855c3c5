#include "app/console/format_texts.h"

#include "core/base/list_text.h"
#include "core/exchange/file_format.h"

namespace alidade::console {

namespace {

/// Replaces blanks by line ends, so that each line fits a terminal's help text.
std::string wrappedText(std::string text) {
  constexpr std::size_t longestLine = 100;
  for (std::size_t start = 0; text.size() - start > longestLine;) {
    const std::size_t blank = text.rfind(' ', start + longestLine);
    if (blank == std::string::npos || blank <= start) break;
    text[blank] = '\n';
    start = blank + 1;
  }
  return text;
}

}  // namespace

std::string readableFormatsSentence() {
  return wrappedText("Read are " + readableKinds() + ".") + "\n";
}

std::string formatNames() {
  const auto names = readableFormats();
  return listed({names.begin(), names.end()});
}

}  // namespace alidade::console
