#pragma once

#include <vector>

#include "core/diagnosis/search/inquiry.h"

namespace alidade {

// What these readings cannot tell from the parts of an explanation.

/// A component that leaves nearly what the part leaves, beside the other parts.
struct Rival {
  /// Of the explanation with it in place of the part, against the one at hand; of a jump in place of a
  /// gross error half of that, since either circle of the row may be the one that was misread.
  double odds = 0;
  Part part;  ///< what takes the part's place
  /// Its size is known beforehand, and that this holds no longer is out of proportion: told apart by what is
  /// known, not by these readings.
  bool isExcluded = false;
};

/// Of each part: effects; of a gross error the jump that only its row would show.
std::vector<std::vector<Rival>> rivalsOf(const Inquiry& inquiry, const Explanation& explanation);

/// Of a jump `part` of the explanation the jumps between another zero and its first place that leave nearly
/// the same: it is one cause by any of them, but not to every further reading.
std::vector<Rival> otherSlips(const Inquiry& inquiry, const Explanation& explanation, std::size_t part);

/// That the part or one of its rivals is among the causes, whatever goes with it: 0…1.
double chanceOf(const Inquiry& inquiry, const Part& part, const std::vector<Rival>& rivals);

}  // namespace alidade
