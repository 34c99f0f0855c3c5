#include "core/base/limits.h"

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
  return {"is larger than " + asMebibytes(mostBytes) + ": choose another file"};
}

Problem tooManyRows() {
  return {"holds more than " + asCount(mostRows) + " rows of readings: divide them into several sessions"};
}

std::string beyondTheRows() {
  return "comes after " + asCount(mostRows) + " rows of readings, and no more are read: divide the file";
}

}  // namespace alidade::limits
