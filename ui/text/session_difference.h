#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade::ui {

/// One entry that differs between two sessions: its name and both texts.
struct EntryDifference {
  QString where, mine, theirs;
};

/// The differences of two sessions, entry by entry.
struct SessionDifference {
  static constexpr std::size_t most = 1000;

  std::vector<EntryDifference> entries;  ///< the first `most`
  std::size_t count = 0;                 ///< number of all differences; 0: both sessions give the same file
};

/// Skips equal rows at both ends of a position, compares the rows between in pairs, and lists surplus rows
/// whole. If only entries that no form or table shows differ, one difference without texts is listed.
SessionDifference differenceOf(const Session& mine, const Session& theirs);

/// "3 entries differ", "1 entry differs".
QString differenceCount(const SessionDifference& difference);

}  // namespace alidade::ui
