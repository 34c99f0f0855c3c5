#pragma once

#include <string>

#include "core/base/place.h"

namespace alidade {

/// The reason why an input cannot be used: one sentence with the error and the remedy, and the place in the
/// session.
struct Problem {
  std::string what;  ///< e.g. `“88°71'49"” has 71 minutes; minutes go from 0 to 59`
  Place where = {};

  /// `positions[1].readings[3].vertical: …`, or only the sentence if there is no place.
  std::string text() const;

  bool operator==(const Problem&) const = default;
};

}  // namespace alidade
