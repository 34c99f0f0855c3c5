#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/recording.h"

namespace alidade {

/// Lines that cannot be used for one reason: the first of them, and how many there are.
struct ProblemGroup {
  LineProblem first;
  std::size_t count = 1;

  std::string text() const;  ///< `line 3, column 12: …`, and how many more there are
};

/// Problems that differ by what was read only are of one kind. In the order in which the kinds come first.
std::vector<ProblemGroup> grouped(const std::vector<LineProblem>& problems);

}  // namespace alidade
