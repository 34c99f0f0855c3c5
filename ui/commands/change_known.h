#pragma once

#include <string>

#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;

/// An editable text of a known size.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< its name in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Sets one text of a known size. In a row without an entry, the first text creates an entry in its owner's
/// list; removing the last text removes the entry. Without a change there is no undo step.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

}  // namespace alidade::ui
