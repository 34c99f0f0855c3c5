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

// Numbers for sentences, screen and paper: a decimal point, a real minus sign (−), never "−0.0", and an em
// dash if not finite; and their decimals. Files use the functions above instead.

/// `value` with `decimals` (0…9) places: "−0.835".
std::string displayText(double value, int decimals);

/// The shortest text for the same number: "2405", "0.95", "−2.5".
std::string displayShortest(double value);

/// A number of things: "31", or with one decimal if some count in part: "2.5".
std::string displayCount(double count);

/// A share of 0…1 in percent, without the digits of rounding: "95", "99.73".
std::string displayPercent(double share);

/// "1.31 mm ± 0.21 mm".
std::string lengthWithUncertainty(double value, double expanded, int decimals);

/// The decimals that show `uncertainty` (> 0) with two significant digits: 3 for 0.0147, 2 for 0.0996, 0 for
/// 12 and more. `fallback` if the uncertainty is zero or not finite.
int decimalsFor(double uncertainty, int fallback = 4);

}  // namespace alidade
