#pragma once

#include <cstddef>
#include <memory>

#include "core/base/place.h"

namespace alidade::ui {

class ReadingsPatch;

/// What became different in the session, told to every view.
struct SessionChange {
  enum class Kind {
    Everything,  ///< another session: new, loaded or imported
    Field,       ///< the single text at `place`
    Readings,    ///< rows of `place.position` from `place.reading` on: `removed` gone, `inserted` new
    Positions,   ///< from `place.position` on: `removed` gone, `inserted` new
  };

  Kind kind = Kind::Everything;
  Place place = {};
  std::size_t removed = 0;
  std::size_t inserted = 0;
  /// Of rows: what was made of them, or, `isReverted`, undone.
  std::shared_ptr<const ReadingsPatch> patch = nullptr;
  bool isReverted = false;
  std::size_t journalKept = 0;  ///< entries of the journal that are as before; all behind them are new
};

}  // namespace alidade::ui
