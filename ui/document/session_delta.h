#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/session/session.h"
#include "ui/document/session_change.h"

namespace alidade::ui {

/// One change of a session with its news, to be made on a copy elsewhere. Holds the rows and texts that are
/// new, and the whole session only where much of it is.
class SessionDelta {
 public:
  /// `after`: the session as `change` has left it.
  SessionDelta(const Session& after, const SessionChange& change);

  /// `session` becomes as `after` was, where it was as before the change.
  void applyTo(Session& session) const;
  /// How many rows are held.
  std::size_t rowCount() const;

 private:
  using Rows = std::vector<Reading>;
  using Effects = std::vector<std::string>;
  using Known = std::vector<KnownSize>;

  SessionChange m_change;
  std::vector<JournalEntry> m_journal;  ///< new entries
  std::variant<Session, std::string, Effects, Known, Rows> m_news;
};

}  // namespace alidade::ui
