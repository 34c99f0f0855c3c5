#include "core/simulation/typed_angle.h"

#include <cmath>

#include "core/base/angle_text.h"

namespace alidade {

namespace {

/// Decimals that show multiples of `step`: 1 for 0.1″, 0 for 5″.
int decimalsOf(double step) {
  int decimals = 0;
  for (double scaled = step; decimals < 9 && std::abs(scaled - std::round(scaled)) > 1e-6 * scaled;
       scaled *= 10)
    ++decimals;
  return decimals;
}

}  // namespace

std::string typedAngle(Angle angle, const Angle& step) {
  const double steps = std::round(angle.radians() / step.radians());
  return formatDms(step * steps, decimalsOf(step.arcseconds()), AngleSigns::Typewriter);
}

std::string typedOnCircle(Angle angle, const Angle& step) {
  const double steps = std::round(wrapped(angle, Angle::fromDegrees(180)).radians() / step.radians());
  const double stepsOfTurn = std::round(Angle::fromDegrees(360).radians() / step.radians());
  return typedAngle(step * (steps < stepsOfTurn ? steps : 0), step);
}

}  // namespace alidade
