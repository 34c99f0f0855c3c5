#include "core/base/quantity_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace alidade {

namespace {

std::string withRealMinus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "−");
  return text;
}

constexpr const char* notFinite = "—";

}  // namespace

std::string displayText(double value, int decimals) {
  return std::isfinite(value) ? withRealMinus(fixedText(value, decimals)) : notFinite;
}

std::string displayShortest(double value) {
  return std::isfinite(value) ? withRealMinus(shortestText(value)) : notFinite;
}

int decimalsFor(double uncertainty, int fallback) {
  if (!std::isfinite(uncertainty) || uncertainty <= 0) return fallback;
  // 0.0996 rounds up to 0.10: judge the size after rounding to two digits.
  constexpr double roundsUp = 0.995;
  constexpr int mostDecimals = 9;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(uncertainty / roundsUp))), 0, mostDecimals);
}

std::string lengthWithUncertainty(double value, double expanded, int decimals) {
  return displayText(value, decimals) + " mm ± " + displayText(expanded, decimals) + " mm";
}

}  // namespace alidade
