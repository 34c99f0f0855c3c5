#pragma once

#include <QString>
#include <cstddef>

#include "core/session/measurement.h"
#include "core/session/session.h"
#include "core/wording/position_name.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

/// The name of a position (`positionName`): "0°", "0° again".
inline QString positionText(int axisDeg, int repeat = 1) {
  return qText(positionName(axisDeg, repeat));
}

/// The name of the session's position at this index in file order; as typed if its axis is invalid.
QString positionText(const Session& session, std::size_t position);

/// The name of a sighting: "Axis at 0°, point 3, round 1, face 2".
QString sightingText(int axisDeg, int repeat, int point, int round, int face);

/// The mean of a pointing zero with its σ and the movement of the zero. `position`: index in the session.
/// Empty for a position that is not evaluated, and for a single sighting unless face 2 was ignored.
QString meanZeroText(const Examined& examined, std::size_t position);

}  // namespace alidade::ui
