#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/recording.h"

namespace alidade {

/// Lines that cannot be used for the same reason: the first of them, and their number.
struct ProblemGroup {
  LineProblem first;
  std::size_t count = 1;

  std::string text() const;  ///< `line 3, column 12: …`, and the number of others
};

/// Groups problems that differ only in quoted texts and numbers, in the order of their first occurrence.
std::vector<ProblemGroup> grouped(const std::vector<LineProblem>& problems);

}  // namespace alidade
