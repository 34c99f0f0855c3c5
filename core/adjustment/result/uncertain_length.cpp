#include "core/adjustment/result/uncertain_length.h"

#include <algorithm>
#include <cmath>

#include "core/base/square.h"

namespace alidade {

UncertainLength lengthOf(const UncertainVector& vector) {
  const double length = std::hypot(vector.x, vector.y);
  const bool hasDirection = length > 0;
  const double c = hasDirection ? vector.x / length : 1, s = hasDirection ? vector.y / length : 0;
  const auto varianceAlong = [&](double alongX, double alongY) {
    return square(alongX) * vector.varianceX + square(alongY) * vector.varianceY +
           2 * alongX * alongY * vector.covariance;
  };
  const double along = varianceAlong(c, s), across = std::max(varianceAlong(-s, c), 0.0);
  const double ofBend = hasDirection ? square(across / length) / 2 : across;
  return {length, std::sqrt(std::max(along, 0.0) + std::min(ofBend, across))};
}

}  // namespace alidade
