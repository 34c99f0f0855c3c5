#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade {

/// Reads a decimal number as typed: optional sign (+, - or −), digits with a point or a comma as decimal
/// sign, optional exponent, blanks around. The whole text must be the number; it must be finite. Thousands
/// separators are refused.
Result<double> parseNumber(std::string_view text);

/// Reads a whole number of at most nine digits, with the same signs and blanks.
Result<int> parseWhole(std::string_view text);

/// The shortest decimal text that reads back as the same double.
std::string shortestText(double value);

/// `value` with `decimals` places, a point, and an ASCII minus; never "-0.00".
std::string fixedText(double value, int decimals);

}  // namespace alidade
