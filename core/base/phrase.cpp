#include "core/base/phrase.h"

#include <atomic>

namespace alidade {

namespace {

std::atomic<Phrase::Interpreter> interpreterOfAll = nullptr;

}  // namespace

void Phrase::setInterpreter(Interpreter interpreter) {
  interpreterOfAll = interpreter;
}

std::string Phrase::interpreted(const char* english) {
  const Interpreter interpreter = interpreterOfAll;
  return interpreter ? interpreter(english) : english;
}

std::string Phrase::filled(const std::string& text, const std::vector<PhraseValue>& values) {
  if (values.empty()) return text;
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isMark = text[at] == '%' && at + 1 < text.size() && text[at + 1] > '0' && text[at + 1] <= '9';
    const std::size_t index = isMark ? static_cast<std::size_t>(text[at + 1] - '1') : values.size();
    if (index < values.size()) {
      result += values[index].text();
      ++at;
    } else {
      result += text[at];
    }
  }
  return result;
}

}  // namespace alidade
