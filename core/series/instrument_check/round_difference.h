#pragma once

#include <cstddef>
#include <optional>

#include "core/base/angle.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

/// A target at different places in two rounds.
struct RoundDifference {
  std::size_t first = 0, second = 0;  ///< indices of its pairs in the two rounds
  Angle by = {};                      ///< angle from its place in the first round, ≥ 0
  bool isVertical = false;            ///< in the vertical circle, else in the horizontal one
  bool isReversed = false;            ///< the horizontal circles count in opposite directions
};

/// The number of targets in both rounds.
std::size_t commonTargets(const ObservedRound& first, const ObservedRound& second);

/// The target whose place differs most between the rounds, if it differs by more than `most`. Directions are
/// compared relative to their lower median, since the circle may have been reset.
std::optional<RoundDifference> differenceOf(const ObservedRound& first, const ObservedRound& second,
                                            Angle most);

}  // namespace alidade
