#pragma once

#include <string>

#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;

/// An editable member of an entry.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< its name in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Types `text` into one cell of a row of the session. The first text of a parameter creates its entry in the
/// proper list; removing the last text removes the entry. Without a change there is no undo step.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

}  // namespace alidade::ui
