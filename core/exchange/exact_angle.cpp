#include "core/exchange/exact_angle.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/base/typed_text.h"
#include "core/exchange/recording.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Is this a number of at most 15 digits, with at most one point after a digit? No circle has more digits.
bool isCircleNumber(const std::string& number) {
  constexpr std::size_t most = 15;
  const auto digits = std::count_if(number.begin(), number.end(), isDigit);
  const auto points = std::count(number.begin(), number.end(), '.');
  return digits > 0 && points <= 1 && static_cast<std::size_t>(digits) <= most &&
         static_cast<std::size_t>(digits + points) == number.size() && number.front() != '.';
}

/// Converts mil to degrees: 6400 mil are 360°, so 1 mil is 0.05625°.
std::string milInDegrees(const std::string& number) {
  constexpr std::uint64_t perMil = 5625;
  constexpr std::size_t decimalsPerMil = 5;
  std::string digits = number;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::size_t decimals = digits.size() - std::min(point + 1, digits.size());
  std::erase(digits, '.');
  digits = std::to_string(std::stoull(digits) * perMil);
  decimals += decimalsPerMil;
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  return digits.substr(0, digits.size() - decimals) + "." + digits.substr(digits.size() - decimals) + "°";
}

/// `number`, or 0 with the same decimals if its value is exactly `turn`.
std::string withoutFullTurn(const std::string& number, std::string_view turn) {
  const std::size_t first = std::min(number.find_first_not_of('0'), number.size());
  const std::size_t point = std::min(number.find('.'), number.size());
  if (first > point || number.substr(first, point - first) != turn) return number;
  const bool isWhole = number.find_first_not_of("0.", point) == std::string::npos;
  return isWhole ? "0" + number.substr(point) : number;
}

std::string twoDigits(unsigned long long number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// Splits 89.1413 into 89°14'13".
SexagesimalParts partsOf(const std::string& number) {
  constexpr std::size_t minuteAndSecond = 4;
  const std::size_t point = std::min(number.find('.'), number.size());
  std::string decimals = point < number.size() ? number.substr(point + 1) : std::string();
  decimals.resize(std::max(decimals.size(), minuteAndSecond), '0');
  return {.degrees = std::stoull(number.substr(0, point)),
          .minutes = std::stoull(decimals.substr(0, 2)),
          .seconds = std::stoull(decimals.substr(2, 2)),
          .decimals = decimals.substr(minuteAndSecond)};
}

/// The angle of a number without a sign, in the given unit.
std::optional<ExactAngle> inUnit(const std::string& plain, const std::string& unit) {
  if (unit == "GON" || unit == "GRD")
    return ExactAngle{withUnit(withoutFullTurn(plain, "400"), AngleUnit::Gon)};
  if (unit == "DEG") return ExactAngle{withUnit(withoutFullTurn(plain, "360"), AngleUnit::Degrees)};
  if (unit == "DMS") return exactAngle(partsOf(plain), false);
  if (unit == "MIL") return ExactAngle{milInDegrees(withoutFullTurn(plain, "6400"))};
  return std::nullopt;
}

}  // namespace

bool SexagesimalParts::carry() {
  const auto carryInto = [](unsigned long long& part, unsigned long long& next) {
    constexpr unsigned long long whole = 60;
    if (part != whole) return false;
    part = 0;
    ++next;
    return true;
  };
  const bool isDegree = carryInto(minutes, degrees), isMinute = carryInto(seconds, minutes);
  return carryInto(minutes, degrees) || isMinute || isDegree;
}

void SexagesimalParts::wrapFullTurn() {
  constexpr unsigned long long turn = 360;
  const bool isWhole = minutes == 0 && seconds == 0 && decimals.find_first_not_of('0') == std::string::npos;
  if (degrees == turn && isWhole) degrees = 0;
}

std::string SexagesimalParts::text(bool hasSigns) const {
  std::string text = std::to_string(degrees) + (hasSigns ? "°" : " ") + twoDigits(minutes) +
                     (hasSigns ? "'" : " ") + twoDigits(seconds);
  if (!decimals.empty()) text += "." + decimals;
  return hasSigns ? text + '"' : text;
}

ExactAngle exactAngle(SexagesimalParts parts, bool hasSigns) {
  const bool isCarried = parts.carry();
  parts.wrapFullTurn();
  return {.text = parts.text(hasSigns), .isCarried = isCarried};
}

std::optional<ExactAngle> exactAngle(const std::string& number, const std::string& unit) {
  std::string sign, plain = number;
  if (!plain.empty() && (plain[0] == '-' || plain[0] == '+')) {
    if (plain[0] == '-') sign = "-";
    plain.erase(0, 1);
  }
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (plain.ends_with('.')) plain.pop_back();
  if (plain.starts_with('.')) plain.insert(0, "0");
  if (!isCircleNumber(plain)) return std::nullopt;
  std::optional<ExactAngle> angle = inUnit(plain, upperCase(unit));
  if (angle) angle->text.insert(0, sign);
  return angle;
}

}  // namespace alidade
