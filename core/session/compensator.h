#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

// Prior knowledge of the instrument's errors from its compensator and correction switches.
//
// The vertical axis is tilted by small angles, towards the observer by tx and to the left by tz, as in the
// forward model (`VerticalAxisTiltX`, `VerticalAxisTiltZ`). The compensator is in the alidade, at the azimuth
// a from the perpendicular of the arc plane, right positive. In face 2 it is rotated by half a turn. It reads
//
//   length = ±(−tx cos a − tz sin a) along the line of sight, > 0 in face 1 if the axis leans to the target
//   cross = ±(tx sin a − tz cos a) across it, > 0 in face 1 if the axis leans to the right
//
// with + in face 1 and − in face 2. Each reading has an index, whose sign is the same in both faces.
//
// The signs of length and cross are a convention of the session file. The available documents do not say how
// GeoCOM (TMC_GetAngle1) counts its cross and length inclination: a wrong sign must be detectable. A tilt of
// the wrong sign is treated as a stale known number (`KnownNumber::staleChance`). The sign is reported as
// wrong if the readings fit the opposite sign.

/// The tilt of the vertical axis, rad.
struct AxisTilt {
  double aboutX = 0, aboutZ = 0;
};

/// The readings of a compensator without an index, rad.
struct TiltsRead {
  double cross = 0, length = 0;
};

TiltsRead tiltsRead(const AxisTilt& tilt, Angle a, int face);

/// Reasons why an error is unknown, or less well known.
struct CompensatorNotes {
  /// Keys of switches whose state differs between rows, or is known for some rows only.
  std::vector<std::string_view> mixed = {};
  /// There are tilts, but no row states whether the instrument has corrected for them.
  bool isInclinationUnknown = false;
  /// The largest change of the tilt between two positions, if it significantly exceeds its uncertainty.
  std::optional<Angle> moved = {};
  /// The larger index (cross, length) if significantly above the compensator's σ. Then no tilt is known.
  std::optional<Angle> index = {};
};

struct CompensatorKnowledge {
  std::vector<KnownNumber> known;
  CompensatorNotes notes;
};

/// Knowledge from the rows of a session; empty if no row states tilts or corrections. Pointing zeros are
/// assumed to have been sighted with the switches of the rows. The chances of being stale are choices, not
/// measured.
///
/// - Inclination is on in all rows: the instrument has corrected for its tilt, so tx and tz are 0 ± σ of the
///   compensator. If standing axis is not on in all rows, the chance of being stale is 0.1, as the instrument
///   may have corrected the vertical circle only.
/// - Inclination is off in all rows, and there are tilts: tx, tz and the indices are fitted to all rows. The
///   indices are free if both faces have tilts, else 0 ± σ of the compensator. The uncertainty includes this
///   σ, which all rows share, a free index, and half the range between positions. The chance of being stale
///   is one half: the sign convention of an instrument is unknown until readings have shown it.
/// - Collimation or tilting axis is on in all rows: this error is 0 ± 5″, the residual of the instrument's
///   own calibration, which changes with time, transport and temperature (Leica TPS1100 User Manual, Checking
///   and adjusting). The 5″, a sixth of the plausible size, and a chance of 0.05 of being stale are choices.
/// - A switch that differs between rows yields no knowledge.
CompensatorKnowledge compensatorKnowledge(const Measurement& measurement);

}  // namespace alidade
