#include "core/base/angle.h"

#include <cmath>

namespace alidade {

Angle wrapped(Angle angle, Angle centre) {
  constexpr double pi = std::numbers::pi;
  const double low = centre.radians() - pi;
  const double high = centre.radians() + pi;
  if (angle.radians() >= low && angle.radians() < high) return angle;

  const double offset = std::remainder(angle.radians() - centre.radians(), 2 * pi);
  const double value = centre.radians() + offset;
  if (value >= high || value < low) return Angle::fromRadians(low);
  return Angle::fromRadians(value);
}

Angle wrappedAsWritten(Angle angle, int decimals, Angle centre) {
  const double perArcsecond = std::pow(10.0, decimals);
  return wrapped(Angle::fromArcseconds(std::round(angle.arcseconds() * perArcsecond) / perArcsecond), centre);
}

void MeanDirection::add(Angle direction) {
  m_cosine += std::cos(direction.radians());
  m_sine += std::sin(direction.radians());
}

Angle MeanDirection::value() const {
  return Angle::fromRadians(std::atan2(m_sine, m_cosine));
}

}  // namespace alidade
