#pragma once

#include <cstddef>
#include <vector>

namespace alidade::ui {

class SessionDocument;

/// Takes rows of one position to the end of another, in their order, as one undo step: they were typed or
/// imported at the wrong axis. Rows that are not there are passed over.
void moveRows(SessionDocument& document, std::size_t from, const std::vector<std::size_t>& rows,
              std::size_t to);

}  // namespace alidade::ui
