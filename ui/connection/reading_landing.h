#pragma once

#include <QString>
#include <cstddef>
#include <optional>

#include "core/base/place.h"
#include "core/connection/instrument_reading.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

class SessionDocument;

/// Where a reading of an instrument goes.
struct Landing {
  std::size_t position = 0;
  std::optional<std::size_t> row = {};  ///< the one after the last: a new one; absent: the pointing zero

  Place place() const;  ///< of its horizontal reading
};

/// The entry that is asked for next, beginning with `position`: its pointing zero, its first row still to be
/// read, a row more; else of the next position that has something to be read. Absent: all is read that was to
/// be.
std::optional<Landing> nextLanding(const Evaluation& evaluation, std::size_t position);

/// What speaks against it, as a sentence: another target, another face, something that stands there. Empty:
/// nothing.
QString landingDoubt(const Evaluation& evaluation, const Landing& landing, const InstrumentReading& reading);

/// Puts it there as one step to undo.
void land(SessionDocument& document, const Landing& landing, const InstrumentReading& reading);

}  // namespace alidade::ui
