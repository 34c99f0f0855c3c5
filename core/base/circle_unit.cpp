#include "core/base/circle_unit.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/angle_text.h"
#include "core/base/quantity_text.h"
#include "core/base/typed_text.h"

namespace alidade {

namespace {

struct BareNumber {
  std::size_t digits = 0;  ///< digits before the decimal sign; 0: not a bare number
  bool hasDecimals = false;
};

BareNumber bareNumber(const std::string& typed) {
  const std::string plain = plainSigns(typed);
  std::string_view body = plain;
  if (!body.empty() && (body.front() == '-' || body.front() == '+')) body.remove_prefix(1);
  const auto isDigits = [](std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, isDigit);
  };
  const std::size_t sign = body.find_first_of(".,");
  const bool hasDecimals = sign != std::string_view::npos;
  if (!isDigits(body.substr(0, sign)) || (hasDecimals && !isDigits(body.substr(sign + 1)))) return {};
  return {hasDecimals ? sign : body.size(), hasDecimals};
}

/// Returns the angle in degrees or gon.
double valueIn(CircleUnit unit, Angle angle) {
  return unit == CircleUnit::Gon ? angle.degrees() / 0.9 : angle.degrees();
}

}  // namespace

std::string completedAngle(const std::string& typed, CircleUnit unit) {
  const BareNumber number = bareNumber(typed);
  if (number.digits == 0) return typed;
  constexpr std::size_t mostDigits = 3;
  if (unit == CircleUnit::Gon) return typed + "gon";
  if (unit == CircleUnit::Degrees && number.hasDecimals && number.digits <= mostDigits) return typed + "°";
  return typed;
}

int decimalsOf(Angle angle, CircleUnit unit) {
  constexpr int most = 3, usual = 1;
  const double value = unit == CircleUnit::Dms ? angle.arcseconds() : valueIn(unit, angle) * 1e4;
  for (int decimals = 0; decimals <= most; ++decimals) {
    const double scaled = value * std::pow(10, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-3 * std::pow(10, decimals - most)) return decimals;
  }
  return usual;
}

std::string formatAngle(Angle angle, CircleUnit unit, int decimals) {
  if (unit == CircleUnit::Dms) return formatDms(angle, decimals);
  return displayText(valueIn(unit, angle), decimals + 4) + (unit == CircleUnit::Gon ? " gon" : "°");
}

}  // namespace alidade
