#include "core/base/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::size_t mostWholeDigits = 9;

std::size_t skipDigits(std::string_view text, std::size_t at) {
  while (at < text.size() && isDigit(text[at])) ++at;
  return at;
}

std::size_t skipSign(std::string_view text, std::size_t at) {
  return at < text.size() && (text[at] == '+' || text[at] == '-') ? at + 1 : at;
}

/// The end of the number at the start of `text`; 0 if there is none.
std::size_t numberEnd(std::string_view text) {
  const std::size_t whole = skipSign(text, 0);
  std::size_t end = skipDigits(text, whole);
  std::size_t digits = end - whole;
  if (end < text.size() && (text[end] == '.' || text[end] == ',')) {
    const std::size_t decimals = end + 1;
    end = skipDigits(text, decimals);
    digits += end - decimals;
  }
  if (digits == 0) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const std::size_t exponent = skipSign(text, end + 1);
    if (const std::size_t last = skipDigits(text, exponent); last > exponent) return last;
  }
  return end;
}

/// Is the text one to nine digits without a sign?
bool isPlainWhole(std::string_view text) {
  return !text.empty() && text.size() <= mostWholeDigits && skipDigits(text, 0) == text.size();
}

std::string whyNoNumber(std::string_view typed, std::string_view plain, std::size_t end) {
  if (end == 0) return Phrase::of("%1 is not a number: type one such as 2405 or 2405.5", quotation(typed));
  const std::string_view rest = plain.substr(end);
  if (rest.find_first_of("0123456789") != std::string_view::npos) {
    return Phrase::of("%1 is not one number: type digits with one decimal sign and nothing between them",
                      quotation(typed));
  }
  return Phrase::of("%1 contains more than a number: leave out %2 (the unit is fixed)", quotation(typed),
                    quotation(rest.substr(rest.find_first_not_of(' '))));
}

std::string withRealMinus(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at))
    text.replace(at, 1, "−");
  return text;
}

constexpr const char* notFinite = "—";

}  // namespace

Result<double> parseNumber(std::string_view text) {
  std::string plain = plainSigns(text);
  if (plain.empty()) return Problem{Phrase::of("is empty: type a number")};
  const std::size_t end = numberEnd(plain);
  if (end < plain.size()) return Problem{whyNoNumber(text, plain, end)};

  std::replace(plain.begin(), plain.end(), ',', '.');
  const char* first = plain.data() + (plain[0] == '+' ? 1 : 0);
  double value = 0;
  const auto [last, error] = std::from_chars(first, plain.data() + plain.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) {
    return Problem{
        Phrase::of("%1 is too large or too small to be worked with: check the exponent", quotation(text))};
  }
  return value;
}

Result<int> parseWhole(std::string_view text) {
  if (isPlainWhole(text)) {
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
  const std::string plain = plainSigns(text);
  if (plain.empty()) return Problem{Phrase::of("is empty: type a whole number")};
  const std::size_t first = skipSign(plain, 0);
  const std::size_t last = skipDigits(plain, first);
  if (last < plain.size() || last == first) {
    return Problem{Phrase::of("%1 is not a whole number: type digits alone", quotation(text))};
  }
  if (last - first > mostWholeDigits) {
    return Problem{Phrase::of("%1 has more than nine digits: type a smaller number", quotation(text))};
  }
  int value = 0;
  std::from_chars(plain.data() + first, plain.data() + last, value);
  return plain[0] == '-' ? -value : value;
}

std::string shortestText(double value) {
  constexpr double smallestPlain = 1e-5, largestPlain = 1e15;
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= smallestPlain && size < largestPlain);
  char text[64];
  const auto result = plain ? std::to_chars(text, text + sizeof text, value, std::chars_format::fixed)
                            : std::to_chars(text, text + sizeof text, value);
  return {text, result.ptr};
}

std::string fixedText(double value, int decimals) {
  constexpr std::size_t mostDigits = 320;  // digits of the largest double, with sign and point
  std::string text(mostDigits + static_cast<std::size_t>(std::max(decimals, 0)), '\0');
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed,
                                    std::max(decimals, 0));
  text.resize(static_cast<std::size_t>(result.ptr - text.data()));
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  if (zero && text[0] == '-') text.erase(0, 1);
  return text;
}

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

std::string displayPercent(double share) {
  constexpr double perUnit = 1e9;
  return displayShortest(std::round(100 * share * perUnit) / perUnit);
}

std::string displayCount(double count) {
  const std::string text = displayText(count, 1);
  return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
}

std::string lengthWithUncertainty(double value, double expanded, int decimals) {
  return displayText(value, decimals) + " mm ± " + displayText(expanded, decimals) + " mm";
}

}  // namespace alidade
