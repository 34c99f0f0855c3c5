#include "core/base/round_numbers.h"

#include <algorithm>
#include <cmath>

namespace alidade {
namespace {

// Makes 4.9999999999 count as 5.
constexpr double slack = 1e-9;

}  // namespace

double roundDown125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value) + slack));
  const double lead = value / decade + slack;
  return decade * (lead >= 5 ? 5 : lead >= 2 ? 2 : 1);
}

double roundUp125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value) + slack));
  const double lead = value / decade - slack;
  return decade * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

int decimalsOfStep(double step) {
  return std::max(0, -static_cast<int>(std::floor(std::log10(step) + slack)));
}

}  // namespace alidade
