#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/journal.h"

namespace alidade {

struct Reading;

// Is a session what its journal makes of it? Each entry holds what it changed from and to, so the journal can
// be taken back entry by entry: a place that does not hold what the entry made of it was changed outside this
// program. What comes out at a seal must be what was sealed. A seal keeps a copy of it (where it is not
// longer than a text of a file may be), so that a change of which no entry tells is found by its place, too;
// older seals keep the digest alone. Taken back exactly: texts of fields and rows, rows that came, went or
// moved. An import, an edit of more than a thousand cells and a position that went are told by one entry
// each, which cannot be taken back: what lies before such an entry is checked only at a seal with its copy.

/// A place that is not as the journal tells.
struct JournalContradiction {
  std::string place;  ///< in the session file, as the journal calls it: "positions[0].readings[3].vertical"
  std::string told;   ///< what the journal or the seal says; empty: nothing
  std::string held;   ///< what the file holds; empty: nothing

  bool operator==(const JournalContradiction&) const = default;
};

struct CheckedSeal {
  enum class State {
    Held,       ///< the content was what the seal says
    Changed,    ///< it was not
    Unchecked,  ///< the content at that time cannot be rebuilt
  };
  Seal seal;
  State state = State::Unchecked;
};

struct JournalCheck {
  std::optional<std::size_t> broken;     ///< `firstBrokenEntry`
  std::optional<std::size_t> backwards;  ///< the first entry that is earlier than the one before it
  std::vector<JournalContradiction> contradictions;
  std::vector<CheckedSeal> seals;  ///< in the order of the journal

  /// No entry and no content was changed outside, as far as the file itself can tell.
  bool holds() const;
};

/// Writes the session once, and again for each seal. Of more than 20 000 rows, no entry is taken back.
JournalCheck checkJournal(const Session& session);

/// A seal's copy of what was sealed, as a session file; empty where it keeps none or another text than it
/// sealed.
std::string sealedContent(const JournalEntry& seal);
/// Gives a seal its copy, unless that is longer than a text of a session file may be.
void keepSealedContent(JournalEntry& seal, const std::string& content);

/// All that is typed in a row, for an entry of one that goes or comes: `horizontal 341°52'24", vertical …`,
/// or `empty row`.
std::string rowText(const Reading& row);

}  // namespace alidade
