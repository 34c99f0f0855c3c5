#pragma once

#include <cstddef>
#include <vector>

namespace alidade::ui {

class SessionDocument;

/// Moves rows of one position to the end of another, in order, as one undo step: they were typed or imported
/// at the wrong axis. Ignores missing rows.
void moveRows(SessionDocument& document, std::size_t from, const std::vector<std::size_t>& rows,
              std::size_t to);

}  // namespace alidade::ui
