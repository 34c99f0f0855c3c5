#pragma once

#include <string>

#include "core/base/place.h"

namespace alidade {
struct StatedNoise;
}

namespace alidade::ui {

class SessionDocument;

/// Sets the field at `place` to `typed`: a day in the session's form (`completedDay`), a number without its
/// unit (`withoutUnit`). Does nothing if the field already has this text.
void changeField(SessionDocument& document, const Place& place, const std::string& typed);

/// Sets the σ of both circles as one undo step.
void stateNoise(SessionDocument& document, const StatedNoise& noise);

}  // namespace alidade::ui
