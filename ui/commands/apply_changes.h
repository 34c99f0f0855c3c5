#pragma once

#include <QString>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"

namespace alidade::ui {

class SessionDocument;

/// Types the texts of `changes` into their cells as one undo step. Ignores missing cells; without an
/// effective change there is no undo step.
void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes, const QString& undoText);

}  // namespace alidade::ui
