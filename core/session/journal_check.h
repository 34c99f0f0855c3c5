#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/session/journal.h"

namespace alidade {

struct Reading;

// Does a session agree with its journal? Each entry holds the old and the new value, so the journal can be
// reverted entry by entry. A place that differs from an entry's new value was changed outside this program.
// The content at a seal must be the sealed one. A seal keeps a copy of the content, which locates even an
// unrecorded change. Older seals, and seals of content above the longest text of a file, have only a digest.
// Texts of fields and rows, and rows that were added, deleted or moved, are reverted exactly. An import, an
// edit of more than a thousand cells and a deleted position have one entry each, which cannot be reverted.
// Anything before such an entry is checked only at a seal with a copy.

/// A place that contradicts the journal.
struct JournalContradiction {
  std::string place;  ///< in the session file, as named in the journal: "positions[0].readings[3].vertical"
  std::string recorded;  ///< value according to the journal or the seal; empty: none
  std::string held;      ///< value in the file; empty: none

  bool operator==(const JournalContradiction&) const = default;
};

struct CheckedSeal {
  enum class State {
    Held,       ///< the content matched the seal
    Changed,    ///< the content differed from the seal
    Unchecked,  ///< the content at that time cannot be reconstructed
  };
  Seal seal;
  State state = State::Unchecked;
};

struct JournalCheck {
  std::optional<std::size_t> broken;     ///< `firstBrokenEntry`
  std::optional<std::size_t> backwards;  ///< the first entry that is earlier than its predecessor
  std::vector<JournalContradiction> contradictions;
  std::vector<CheckedSeal> seals;  ///< in the order of the journal

  /// Does the file agree with its journal and with those of its seals that can be checked?
  bool holds() const;
};

/// Writes the session once, then once for each seal, or up to 64 times if empty members may have been absent.
/// If a fault is found, all seals are checked twice. With more than 20 000 rows, entries are not reverted.
JournalCheck checkJournal(const Session& session);

/// A seal's copy of the sealed content, as a session file; empty if there is no copy or its digest is not
/// that of the seal.
std::string sealedContent(const JournalEntry& seal);
/// Adds the copy to a seal, unless it exceeds the longest text of a session file.
void keepSealedContent(JournalEntry& seal, const std::string& content);

/// All typed texts of a row, for an entry that adds or deletes it: `horizontal 341°52'24", vertical …`, or
/// `empty row`.
std::string rowText(const Reading& row);

}  // namespace alidade
