#pragma once

#include <limits>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/base/angle.h"

namespace alidade {

/// By which test an error of a reading of one session has to be found, with what chance, in what noise.
struct Detection {
  ReadingTest test = {};
  double power = 0.80;  ///< in (0.5, 1)
  double scale = 1;     ///< s0 > 0: how the readings scatter, over the stated σ
  /// `ReadingTest::detectableShift`, reckoned once.
  double shift = std::numeric_limits<double>::infinity();
};

/// As the search for misread readings tests a session: n different tests, f − 1 degrees of freedom. `scale`:
/// s0 of the fit (`noiseScale`).
Detection detectionIn(const JointFit& fit, double scale, double power = 0.80);

/// How well one reading is checked by the others, after Baarda, "A testing procedure for use in geodetic
/// networks" (1968), for the test that is used.
struct Reliability {
  /// The smallest error of the reading that the test finds with the chance asked for: δ s0 σ/√r, with δ the
  /// shift that is detected, σ stated and r the redundancy. The first reading of Table I: 34 places make as
  /// many tests at 1 % in all, |t| from 4.152 on with 27 degrees of freedom, so δ = 5.080, and with s0
  /// = 6.912, σ = 2″ and r = 0.612 it is 89.8″. (A normal test of one reading alone at 0.1 % in the stated
  /// noise would find 10.6″.) A gross error that is in s0 makes it larger. Infinite where nothing checks the
  /// reading, or the fit has fewer than two degrees of freedom.
  Angle minimalDetectableBias;
  double influence = 0;  ///< what such an error, unfound, does to Δd, mm, signed as the error; infinite along
                         ///< with it unless none
};

Reliability reliabilityOf(const AdjustedReading& reading, const Detection& detection);

}  // namespace alidade
