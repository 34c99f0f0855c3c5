#pragma once

#include <string>

namespace alidade {

// The size of an effect in a unit of the catalogue ("arcsec", "mm", "1"), to two digits of the uncertainty.

/// "61.2 ± 8.1″", "−0.298 ± 0.018 mm": the uncertainty is expanded.
std::string sizeWithExpanded(double value, double expanded, const std::string& unit);

/// "3.20″ (u 0.51)": the uncertainty is standard.
std::string sizeWithStandard(double value, double u, const std::string& unit);

/// "12″", "5.8 mm": two digits.
std::string sizeText(double value, const std::string& unit);

}  // namespace alidade
