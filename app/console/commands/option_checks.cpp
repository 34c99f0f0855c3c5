#include "app/console/commands/option_checks.h"

#include <charconv>

#include "core/base/number_text.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"

namespace alidade::console {

namespace {

std::string outside(const std::string& text, const std::string& kind, const std::string& least,
                    const std::string& most) {
  return quotation(text) + " is not " + kind + " from " + least + " to " + most;
}

/// Parses the whole text, with or without a plus sign; false if it is invalid or out of range.
template <typename Value>
bool reads(const std::string& text, Value& value) {
  const char* const end = text.data() + text.size();
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const auto [last, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, value);
  return error == std::errc{} && last == end;
}

}  // namespace

OptionCheck numberFrom(double least, double most) {
  return [least, most](const std::string& text) -> std::string {
    double value = 0;
    // A comparison with NaN is false, so NaN is refused.
    if (reads(text, value) && value >= least && value <= most) return {};
    return outside(text, "a number", shortestText(least), shortestText(most));
  };
}

OptionCheck wholeFrom(std::uint64_t least, std::uint64_t most) {
  return [least, most](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    if (reads(text, value) && value >= least && value <= most) return {};
    return outside(text, "a whole number", std::to_string(least), std::to_string(most));
  };
}

OptionCheck textCheck() {
  return [](const std::string& text) -> std::string {
    if (!firstIllFormedByte(text)) return {};
    return quotation(text) + " is not UTF-8 text: type it again, or set the terminal to UTF-8";
  };
}

AngleUnit angleUnitNamed(const std::string& name) {
  if (name == "gon") return AngleUnit::Gon;
  if (name == "deg") return AngleUnit::Degrees;
  return name == "dms" ? AngleUnit::Dms : AngleUnit::Unstated;
}

}  // namespace alidade::console
