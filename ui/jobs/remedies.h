#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/base/place.h"
#include "ui/jobs/gap.h"

namespace alidade::ui {

/// What can be done about causes that no effect of a model holds.

/// Rows of one position.
struct RowRange {
  std::size_t position = 0, first = 0, count = 0;
};

/// A jump of the orientation within a position.
struct Jump {
  Place place;            ///< the row before which it happened
  bool isLast = false;    ///< no position was read after this one
  bool isAtZero = false;  ///< between the position's pointing zero and its first place
  /// The rows before and after it, where those left over without them suffice for an arc; those before it
  /// only where a later position may stand as those after it.
  std::optional<RowRange> before = {}, after = {};
};

/// Empty where the cause is no jump.
std::optional<Jump> jumpOf(const Gap& gap, const Cause& cause);

/// σ of both circles, arcseconds, as they would be typed.
struct StatedNoise {
  std::string horizontal, vertical;
};

/// What the readings scatter by: the σ stated, larger by the ratio found, two digits of each. Empty where the
/// cause is no larger noise.
std::optional<StatedNoise> scatterOf(const Gap& gap, const Cause& cause);

}  // namespace alidade::ui
