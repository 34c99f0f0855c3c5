#pragma once

#include <QString>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"

namespace alidade::ui {

class SessionDocument;

/// Types the texts of `changes` into their cells as one undo step. Cells that the session does not have are
/// passed over; what would change nothing leaves no undo step.
void applyChanges(SessionDocument& document, const std::vector<CellChange>& changes, const QString& undoText);

}  // namespace alidade::ui
