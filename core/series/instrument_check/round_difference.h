#pragma once

#include <cstddef>
#include <optional>

#include "core/base/angle.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

/// A target that two rounds show at different places.
struct RoundDifference {
  std::size_t first = 0, second = 0;  ///< indices of its pairs in the one round and in the other
  Angle by = {};                      ///< its distance from where the first round has it, ≥ 0
  bool isVertical = false;            ///< by the vertical circle; else by the horizontal one
  bool isReversed = false;            ///< the horizontal circles count in opposite directions
};

/// How many targets both rounds have.
std::size_t commonTargets(const ObservedRound& first, const ObservedRound& second);

/// The target that differs most, where one differs by more than `most`. The circle may be set to another
/// reading between the rounds: directions are compared with each other only.
std::optional<RoundDifference> differenceOf(const ObservedRound& first, const ObservedRound& second,
                                            Angle most);

}  // namespace alidade
