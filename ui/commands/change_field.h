#pragma once

#include <string>

#include "core/base/place.h"

namespace alidade::ui {

class SessionDocument;

/// Stores a day in the session's form (`completedDay`). Does nothing if the field already has this text.
void changeField(SessionDocument& document, const Place& place, const std::string& typed);

}  // namespace alidade::ui
