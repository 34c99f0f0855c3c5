#pragma once

#include "core/evaluation/remedies.h"

namespace alidade::ui {

class SessionDocument;

/// Sets the σ of both circles as one undo step.
void stateNoise(SessionDocument& document, const StatedNoise& noise);

}  // namespace alidade::ui
