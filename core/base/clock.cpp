#include "core/base/clock.h"

#include <array>
#include <ctime>

namespace alidade {

namespace {

std::string written(const char* format, std::tm* (*partsOf)(const std::time_t*, std::tm*)) {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  partsOf(&now, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), format, &parts)};
}

}  // namespace

std::string timeInUtc() {
  return written("%Y-%m-%dT%H:%M:%SZ", gmtime_r);
}

std::string localDay() {
  return written("%Y-%m-%d", localtime_r);
}

}  // namespace alidade
