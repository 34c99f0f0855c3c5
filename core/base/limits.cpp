#include "core/base/limits.h"

#include "core/base/phrase.h"

namespace alidade::limits {

std::string asMebibytes(std::size_t bytes) {
  return std::to_string(bytes >> 20) + " MiB";
}

std::string asCount(std::size_t count) {
  constexpr std::size_t group = 3;
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > group;) text.insert(at -= group, 1, ',');
  return text;
}

Problem tooManyBytes() {
  return {Phrase::of("is larger than %1: choose another file", asMebibytes(mostBytes))};
}

Problem tooManyRows() {
  return {Phrase::of("holds more than %1 rows of readings: divide them into several sessions",
                     asCount(mostRows))};
}

std::string beyondTheRows() {
  return Phrase::of("comes after %1 rows of readings, the limit: divide the file", asCount(mostRows));
}

}  // namespace alidade::limits
