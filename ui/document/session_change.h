#pragma once

#include <cstddef>

#include "core/base/problem.h"

namespace alidade::ui {

/// A change of the session, sent to every view.
struct SessionChange {
  enum class Kind {
    Everything,  ///< another session: new, loaded or imported
    Field,       ///< the single text at `place`
    Readings,    ///< rows of `place.position` from `place.reading` on
    Positions,   ///< positions from `place.position` on
  };

  Kind kind = Kind::Everything;
  Place place = {};
  std::size_t removed = 0;   ///< number of rows or positions removed
  std::size_t inserted = 0;  ///< number of rows or positions added
};

}  // namespace alidade::ui
