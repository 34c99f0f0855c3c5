#pragma once

#include <limits>

#include "core/adjustment/joint/joint_fit.h"
#include "core/adjustment/joint/reading_test.h"
#include "core/base/angle.h"

namespace alidade {

/// The test, power and noise for detecting an error of a reading of one session.
struct Detection {
  ReadingTest test = {};
  double power = 0.80;  ///< in (0.5, 1)
  double scale = 1;     ///< s0 > 0: scatter of the readings divided by the stated σ
  /// `ReadingTest::detectableShift`, computed once.
  double shift = std::numeric_limits<double>::infinity();
};

/// Returns the test of the search for misread readings: n different tests, f − 1 degrees of freedom. `scale`:
/// s0 of the fit (`noiseScale`).
Detection detectionIn(const JointFit& fit, double scale, double power = 0.80);

/// The reliability of one reading: how well other readings check it, after Baarda, "A testing procedure for
/// use in geodetic networks" (1968), for the test in use.
struct Reliability {
  /// The smallest error of the reading that the test finds at the requested power: δ s0 σ/√r, with δ the
  /// detectable shift, σ stated and r the redundancy. Example, first reading of Table I: 34 places make 34
  /// tests at a joint risk of 1 %. With 27 degrees of freedom |t| must reach 4.152, and δ = 5.080. With s0 =
  /// 6.912, σ = 2″ and r = 0.612 the error is 89.8″. (A normal test of one reading alone at 0.1 % in the
  /// stated noise would find 10.6″.) A gross error included in s0 makes the value larger. Infinite if no
  /// other reading checks the reading, or if the fit has fewer than two degrees of freedom.
  Angle minimalDetectableBias;
  double influence = 0;  ///< effect on Δd of an undetected error of this size, mm, of the same sign; if the
                         ///< bias is infinite: infinite, or 0 if the reading does not affect Δd
};

Reliability reliabilityOf(const AdjustedReading& reading, const Detection& detection);

}  // namespace alidade
