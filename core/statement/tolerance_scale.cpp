#include "core/statement/tolerance_scale.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace alidade {

double ToleranceScale::end() const {
  constexpr double beyond = 1.1;  // the limit and the interval end before the scale does
  return beyond * std::max(tolerance, high());
}

std::string scaleText(const ToleranceScale& scale, int width) {
  const int last = std::max(width, 10) - 1;
  const auto at = [&](double length) {
    return static_cast<std::size_t>(
        std::clamp(std::lround(length / scale.end() * last), 0L, static_cast<long>(last)));
  };
  std::string line(at(scale.size), '=');
  line.resize(static_cast<std::size_t>(last) + 1, '-');
  line[at(scale.tolerance)] = ':';
  line[at(scale.low())] = '[';
  line[at(scale.high())] = ']';
  line[at(scale.size)] = '|';
  return "0 " + line + "  " + displayShortest(scale.tolerance) + " mm";
}

}  // namespace alidade
