#pragma once

#include "core/adjustment/joint/joint_fit.h"
#include "core/base/angle.h"

namespace alidade {

/// With what risk of a false alarm, and with what chance, an error of a reading has to be found.
struct DetectionLevel {
  double risk = 0.001;  ///< two-sided, in (0, 1)
  double power = 0.80;  ///< in (0, 1)

  bool operator==(const DetectionLevel&) const = default;
};

/// How well one reading is checked by the others, after Baarda, "A testing procedure for use in geodetic
/// networks" (1968).
struct Reliability {
  /// The smallest error of the reading that a test of its residual finds at the level: δ0 σ/√r with the
  /// stated σ and redundancy r. Infinite where nothing checks the reading (r below 1e-9).
  Angle minimalDetectableBias;
  double influence = 0;  ///< what such an error, unfound, does to Δd, mm, signed as the error; infinite along
                         ///< with it unless none
};

Reliability reliabilityOf(const AdjustedReading& reading, const DetectionLevel& level = {});

}  // namespace alidade
