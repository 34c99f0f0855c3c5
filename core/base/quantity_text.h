#pragma once

#include <string>

namespace alidade {

// Numbers for sentences, screen and paper: a decimal point, a real minus sign (−), never "−0.0", and an em
// dash if not finite. Files use number_text instead.

/// `value` with `decimals` (0…9) places: "−0.835".
std::string displayText(double value, int decimals);

/// The shortest text for the same number: "2405", "0.95", "−2.5".
std::string displayShortest(double value);

/// "1.31 mm ± 0.21 mm".
std::string lengthWithUncertainty(double value, double expanded, int decimals);

/// The decimals that show `uncertainty` (> 0) with two significant digits: 3 for 0.0147, 2 for 0.0996, 0 for
/// 12 and more. `fallback` if the uncertainty is zero or not finite.
int decimalsFor(double uncertainty, int fallback = 4);

}  // namespace alidade
