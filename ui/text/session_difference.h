#pragma once

#include <QString>
#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade::ui {

/// One entry that is not the same in two sessions: where, as people call it, and both texts.
struct EntryDifference {
  QString where, mine, theirs;
};

/// How two sessions differ, entry by entry.
struct SessionDifference {
  static constexpr std::size_t most = 1000;

  std::vector<EntryDifference> entries;  ///< the first `most`
  std::size_t count = 0;                 ///< of all; 0: a file of either would say the same
};

/// Rows are compared from both ends of a position: what was inserted or deleted in between is told as whole
/// rows. An entry that no form or table shows is told without its texts.
SessionDifference differenceOf(const Session& mine, const Session& theirs);

/// "3 entries differ", "1 entry differs".
QString differenceCount(const SessionDifference& difference);

}  // namespace alidade::ui
