#pragma once

#include <vector>

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// The alternatives that these readings leave for each part of an explanation.

/// A component that explains the readings nearly as well as the part that it replaces.
struct Rival {
  /// Odds of the explanation with this component instead of the part, relative to the explanation itself.
  /// They are halved for a jump instead of a gross error, since either circle of the row may have been
  /// misread.
  double odds = 0;
  Part part;  ///< the replacement
  /// Whether the component is excluded only because its known size makes the necessary change improbable.
  bool isExcluded = false;
};

/// Rivals of each part: effects and jumps between a zero and the first visit; for a gross error, the jumps
/// that only the row of the reading shows.
std::vector<std::vector<Rival>> rivalsOf(const Inquiry& inquiry, const Explanation& explanation);

/// The jumps between another zero and its first visit that explain nearly the same as the jump `part`. All
/// these jumps are one cause in these readings, but further readings may separate them.
std::vector<Rival> otherWrongZeros(const Inquiry& inquiry, const Explanation& explanation, std::size_t part);

/// Probability, 0…1, that the part or one of its rivals is among the causes, in any combination.
double chanceOf(const Inquiry& inquiry, const Part& part, const std::vector<Rival>& rivals);

}  // namespace alidade
