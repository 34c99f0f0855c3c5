#pragma once

#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/series/instrument_check/instrument_check.h"

namespace alidade {

/// Bounds that no theodolite exceeds. The coarsest in use, with a vernier of 1′, reads with a standard
/// deviation of 17″ (1′/√12). The mean of both faces and half their difference then have 12″ (17″/√2).
struct CheckBounds {
  /// s of a direction and of a zenith angle, arcsec: five times the 12″ of the coarsest theodolite.
  double scatter = 60;
  /// Departure of a direction, zenith angle, collimation or index of one target in one round from its median
  /// over the rounds, arcsec: five times the 12″ of the coarsest theodolite.
  double departure = 60;
  /// Collimation, index and tilt of the trunnion axis, arcsec: half a degree. Makers adjust to 30″, and
  /// instruments that correct axis errors refuse errors above about 6′.
  double axisError = 1800;
  /// Offset of the line of sight from the vertical axis, mm. Mechanical tolerances are a few tenths at most.
  double lineOfSight = 5;
  /// Largest share of pairs whose faces differ by more than 2° and that count as misread. A larger share
  /// means that the pairs are mismatched.
  double farApart = 0.25;
};

/// Returns the reason if the figures of the check are implausible, with the lines of the file. The reason is
/// a target at different places from round to round, a horizontal circle that counts in the opposite
/// direction, a jump of the orientation or the index, or a figure beyond `bounds`. Absent if all figures are
/// plausible. `check` is the check of `stations`.
std::optional<Problem> implausibility(const std::vector<StationRounds>& stations,
                                      const InstrumentCheck& check, const CheckBounds& bounds = {});

}  // namespace alidade
