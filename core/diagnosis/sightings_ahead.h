#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/diagnosis/result/diagnosis.h"
#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/measurement.h"

namespace alidade {

/// Sightings that reach an uncertainty, in their order.
struct SightingsAhead {
  std::vector<NextSighting> sightings;
  double minutes = 0;
  /// U of Δd after `sightings`, mm, with every effect of plausible size; absent without both positions.
  std::optional<double> expanded = {};
  bool isReached = false;  ///< whether `expanded` is at most the requested U
  /// If not reached: first U after these sightings. Then, where U falls by a tenth or more, U of as many
  /// sightings with slider readings or in both faces, and U with an effect of known size.
  std::vector<AttainableUncertainty> instead = {};
};

/// The largest number of sightings that is planned ahead.
inline constexpr std::size_t mostAhead = 150;

/// The sightings that bring U of Δd to `uncertainty` (mm, > 0) in the fewest minutes, at the session's
/// coverage. The position of the last reading comes first, then the other position; several divisions of the
/// sightings between both are tried. Each sighting is the one that reduces U most for its minutes. U does not
/// depend on the values of the readings, so the planned readings follow from the arcs fitted so far.
/// `taken` has at least one sighting; `most` limits the planned sightings. The axis is turned at most
/// once, if the plan allows it. On a stop request, returns early with the sightings so far.
SightingsAhead sightingsFor(double uncertainty, const Measurement& taken, const SightingPlan& plan,
                            std::size_t most = mostAhead, const std::stop_token& stop = {});

}  // namespace alidade
