#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/angle.h"
#include "core/session/measurement.h"

namespace alidade {

// What the compensator of the instrument and its correction switches tell beforehand of the instrument's
// errors.
//
// The vertical axis leans towards the observer by tx and to the left by tz, as the forward model has them
// (`VerticalAxisTiltX`, `VerticalAxisTiltZ`), small angles. The compensator sits in the alidade, which stands
// at the azimuth a from the perpendicular of the arc plane, right positive, in face 2 turned half round. It
// reads
//
//   length = ±(−tx cos a − tz sin a)   along the line of sight: the axis leans towards the target
//   cross  = ±(tx sin a − tz cos a)    across it: the axis leans to the right
//
// with + in face 1, each with an index of its own, which does not turn over in face 2.
//
// This sign is a convention of the session file. Which way GeoCOM (TMC_GetAngle1) counts its cross and length
// inclination no document at hand says, so a wrong sign must be found out: it is one way in which a known
// number is stale (`KnownNumber::staleChance`), and where the readings fit the other sign that is told.

/// By how much the vertical axis leans, rad.
struct AxisTilt {
  double aboutX = 0, aboutZ = 0;
};

/// What a compensator without an index reads, rad.
struct TiltsRead {
  double cross = 0, length = 0;
};

TiltsRead tiltsRead(const AxisTilt& tilt, Angle a, int face);

/// What keeps something from being known, or makes it less so.
struct CompensatorNotes {
  /// Keys of switches that were not the same in all rows, or are known of some rows only.
  std::vector<std::string_view> mixed = {};
  /// There are tilts, but of no row it is known whether the instrument has taken them off.
  bool isInclinationUnknown = false;
  /// The largest change from one position to another, where it is more than the compensator's uncertainty.
  std::optional<Angle> moved = {};
  /// What both faces show to be no tilt, where it is more than that: the larger of the two.
  std::optional<Angle> index = {};
};

struct CompensatorKnowledge {
  std::vector<KnownNumber> known;
  CompensatorNotes notes;
};

/// The chances of being stale are choices, too, not measured.
/// What the rows of a session tell; nothing where none tells of tilts or corrections. Pointing zeros are
/// taken to have been sighted with the switches of the rows.
///
/// - Inclination on in all rows: the instrument has taken its tilt off; 0 ± σ of the compensator. With the
///   standing axis off it may have taken it off the vertical circle only: this is stale with a chance of 0.1.
/// - Inclination off in all rows, and tilts: tx and tz by least squares over all rows, with the indices.
///   These are free where both faces have tilts, else 0 ± σ of the compensator. That σ, which all rows share,
///   is added, and half the range between positions. Stale with a chance of one half: nobody knows which way
///   an instrument counts until readings have shown it.
/// - Collimation, tilting axis on in all rows: what the instrument's own calibration has left. These errors
///   change with time, transport and temperature (Leica TPS1100 User Manual, Checking and adjusting), by how
///   much it does not say: 0 ± 5″, stale with a chance of 0.05, are choices, a sixth of the plausible size.
/// - Whatever differs between rows tells nothing.
CompensatorKnowledge compensatorKnowledge(const Measurement& measurement);

}  // namespace alidade
