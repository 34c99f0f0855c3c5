#pragma once

#include <string>

#include "core/adjustment/gross_errors/corrections.h"
#include "core/adjustment/gross_errors/suspects.h"
#include "core/base/angle.h"
#include "core/session/session.h"

namespace alidade {

// What is said of suspect readings, for people.

/// "0°, point 5, vertical"; round and face where they are not 1.
std::string nameOf(const Suspect& suspect);

/// What was typed in a cell of the table of readings.
const std::string& textAt(const Session& session, const Place& where);

/// Horizontal 341°52'24" → 341°25'24": two digits swapped; residual then +1.2″.
std::string sentenceOf(const Session& session, const Correction& correction, Angle residual);

/// Which reading, by how much, and what was probably meant.
std::string sentenceOf(const Suspect& suspect);

}  // namespace alidade
