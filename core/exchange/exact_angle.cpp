#include "core/exchange/exact_angle.h"

#include <algorithm>
#include <cstdint>

#include "core/base/typed_text.h"
#include "core/exchange/recording.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Digits with at most one point; nothing larger or finer than any circle reads.
bool isCircleNumber(const std::string& number) {
  constexpr std::size_t most = 12;
  const auto digits = std::count_if(number.begin(), number.end(), isDigit);
  const auto points = std::count(number.begin(), number.end(), '.');
  return digits > 0 && points <= 1 && static_cast<std::size_t>(digits) <= most &&
         static_cast<std::size_t>(digits + points) == number.size() && number.front() != '.';
}

/// 6400 mil are 360°, so that 1 mil is 0.05625°.
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

}  // namespace

std::optional<std::string> exactAngle(const std::string& number, const std::string& unit) {
  std::string sign, plain = number;
  if (!plain.empty() && (plain[0] == '-' || plain[0] == '+')) {
    if (plain[0] == '-') sign = "-";
    plain.erase(0, 1);
  }
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (plain.ends_with('.')) plain.pop_back();
  if (!isCircleNumber(plain)) return std::nullopt;
  const std::string name = upperCase(unit);
  if (name == "GON" || name == "GRD") return sign + withUnit(plain, AngleUnit::Gon);
  if (name == "DEG") return sign + withUnit(plain, AngleUnit::Degrees);
  if (name == "DMS") return sign + withUnit(plain, AngleUnit::Dms);
  if (name == "MIL") return sign + milInDegrees(plain);
  return std::nullopt;
}

}  // namespace alidade
