#pragma once

#include <cstddef>

namespace alidade::ui {

/// Names one row of readings: indices into the session's positions and that position's readings.
struct SightingRef {
  std::size_t position = 0;
  std::size_t row = 0;

  bool operator==(const SightingRef&) const = default;
};

}  // namespace alidade::ui
