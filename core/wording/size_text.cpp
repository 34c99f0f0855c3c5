#include "core/wording/size_text.h"

#include <cmath>

#include "core/base/number_text.h"
#include "core/wording/effect_name.h"

namespace alidade {

std::string sizeWithExpanded(double value, double expanded, const std::string& unit) {
  const int decimals = decimalsFor(expanded);
  return displayText(value, decimals) + " ± " + displayText(expanded, decimals) + signOf(unit);
}

std::string sizeWithStandard(double value, double u, const std::string& unit) {
  const int decimals = decimalsFor(u);
  return displayText(value, decimals) + signOf(unit) + " (u " + displayText(u, decimals) + ")";
}

std::string sizeText(double value, const std::string& unit) {
  return displayText(value, decimalsFor(std::abs(value))) + signOf(unit);
}

}  // namespace alidade
