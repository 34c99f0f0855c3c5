#pragma once

#include <string>

#include "ui/document/known_entry.h"

namespace alidade::ui {

class SessionDocument;

/// An editable text of a known size.
struct KnownCell {
  std::string KnownSize::*text;
  const char* member;  ///< name of the text in the session file
};
inline constexpr KnownCell knownCells[] = {
    {&KnownSize::value, "value"}, {&KnownSize::sigma, "sigma"}, {&KnownSize::from, "from"}};

/// Sets one text of a known size. In a row without an entry, the first text creates an entry in the list of
/// instrument or device; removing the last text removes the entry. Adds no undo step if nothing changes.
void typeKnown(SessionDocument& document, const KnownRow& row, const KnownCell& cell,
               const std::string& text);

}  // namespace alidade::ui
