#include <algorithm>
#include <charconv>
#include <cstdint>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/gsi_word.h"

namespace alidade {

namespace {

constexpr std::size_t behindDegrees = 5, behindMil = 4;  // implied decimals if no decimal sign is written
constexpr std::uint64_t mostUnits = 1'000'000'000;       // 9 digits are over ten times the largest reading

/// The digits before and after the decimal sign.
struct GsiNumber {
  std::string whole, decimals;
};

bool areDigits(std::string_view text) {
  return std::all_of(text.begin(), text.end(), isDigit);
}

std::string withoutZerosBefore(std::string_view digits) {
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits.empty() ? "0" : std::string(digits);
}

/// Removes leading blanks that pad the data.
std::string_view filledUp(std::string_view data) {
  data.remove_prefix(std::min(data.find_first_not_of(' '), data.size()));
  return data;
}

bool hasPoint(std::string_view data) {
  return data.find_first_of(".,") != std::string_view::npos;
}

/// The number; absent if the data holds none. Without a decimal sign the unit implies `implied` decimals.
std::optional<GsiNumber> numberOf(std::string_view data, std::size_t implied) {
  data = filledUp(data);
  if (data.empty()) return std::nullopt;
  const std::size_t point = data.find_first_of(".,");
  if (point == std::string_view::npos) {
    std::string digits(data);
    if (digits.size() <= implied) digits.insert(0, implied + 1 - digits.size(), '0');
    if (!areDigits(digits)) return std::nullopt;
    const std::size_t behind = digits.size() - implied;
    return GsiNumber{withoutZerosBefore(digits.substr(0, behind)), digits.substr(behind)};
  }
  const std::string_view whole = data.substr(0, point), decimals = data.substr(point + 1);
  if (!areDigits(whole) || !areDigits(decimals) || whole.size() + decimals.size() == 0) return std::nullopt;
  return GsiNumber{withoutZerosBefore(whole), std::string(decimals)};
}

/// Splits DDDMMSS and its decimals into parts.
SexagesimalParts partsOfRun(const std::string& run, const std::string& decimals) {
  constexpr std::uint64_t perMinute = 100, perDegree = 10'000;
  const std::uint64_t digits = std::stoull(run);
  return {.degrees = digits / perDegree,
          .minutes = digits / perMinute % perMinute,
          .seconds = digits % perMinute,
          .decimals = decimals};
}

ExactAngle sexagesimal(GsiNumber number, GsiPoint point) {
  constexpr std::size_t minuteAndSecond = 4;
  if (point == GsiPoint::BehindDegrees) {
    number.decimals.resize(std::max(number.decimals.size(), minuteAndSecond), '0');
    number.whole += number.decimals.substr(0, minuteAndSecond);
    number.decimals.erase(0, minuteAndSecond);
  }
  return exactAngle(partsOfRun(number.whole, number.decimals), true);
}

std::string withSign(const GsiNumber& number) {
  return number.decimals.empty() ? number.whole : number.whole + "." + number.decimals;
}

/// The angle in its unit; absent if the unit does not denote an angle.
std::optional<ExactAngle> inUnitOf(char unit, const GsiNumber& number, GsiPoint point) {
  switch (unit) {
    case '2':
      return exactAngle(withSign(number), "gon");
    case '3':
      return exactAngle(withSign(number), "deg");
    case '4':
      return sexagesimal(number, point);
    case '5':
      return exactAngle(withSign(number), "mil");
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<GsiPoint> gsiPoint(const GsiWord& word) {
  constexpr std::size_t digitsOfDegrees = 3;
  const auto number = hasPoint(word.data) ? numberOf(word.data, 0) : std::nullopt;
  if (!number || number->whole.size() <= digitsOfDegrees) return std::nullopt;
  return GsiPoint::BehindSeconds;
}

std::variant<ExactAngle, LineProblem> gsiExactAngle(const GsiWord& word, std::size_t line,
                                                    std::optional<GsiPoint> point) {
  constexpr std::size_t minutesAndSeconds = 4, mostDigits = 15, narrow = 8;
  const auto refuse = [&](const std::string& why) {
    return LineProblem{line, word.column, gsiWordName(word.index) + " " + quotation(word.data) + " " + why};
  };
  const bool isWritten = hasPoint(word.data);
  if (!word.isWhole && !isWritten)
    return refuse(
        characterCount(word.data) == narrow
            ? Phrase::of("has 8 characters, and a block that starts with * has 16: transfer the file again")
            : Phrase::of(
                  "has neither 8 nor 16 characters: transfer the file again, or correct or delete the line"));
  const auto number = numberOf(word.data, word.unit == '5' ? behindMil : behindDegrees);
  if (!number) return refuse(Phrase::of("is not made of digits: transfer the file again"));
  const std::size_t decimals = number->decimals.size();
  if (number->whole.size() + decimals > mostDigits ||
      (!isWritten && std::stoull(number->whole + number->decimals) >= mostUnits))
    return refuse(Phrase::of("is larger than a full circle: transfer the file again"));
  if (!isWritten)
    point = GsiPoint::BehindDegrees;
  else if (!point)
    point = gsiPoint(word).value_or(decimals < minutesAndSeconds ? GsiPoint::BehindSeconds
                                                                 : GsiPoint::BehindDegrees);
  auto angle = inUnitOf(word.unit, *number, *point);
  if (!angle)
    return refuse(
        Phrase::of("has no angle unit: character 6 of the word is “%1”; valid are 2 (gon), 3 (decimal "
                   "degrees), 4 (degrees minutes seconds), 5 (mil)",
                   std::string(1, word.unit)));
  if (word.sign == '-') angle->text.insert(0, "-");
  return *std::move(angle);
}

std::variant<std::string, LineProblem> gsiAngle(const GsiWord& word, std::size_t line) {
  auto angle = gsiExactAngle(word, line);
  if (auto* problem = std::get_if<LineProblem>(&angle)) return std::move(*problem);
  return std::get<ExactAngle>(std::move(angle)).text;
}

}  // namespace alidade
