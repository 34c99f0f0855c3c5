#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/session/session.h"
#include "ui/document/session_change.h"

namespace alidade::ui {

/// One change of a session with its news, to be made on a copy elsewhere. Shares the patch of rows with the
/// command that made it, holds single texts, and the whole session only where much of it is new.
class SessionDelta {
 public:
  /// `after`: the session as `change` has left it.
  SessionDelta(const Session& after, const SessionChange& change);

  /// `session` becomes as `after` was, where it was as before the change.
  void applyTo(Session& session) const;
  /// How many rows and cells of rows are held.
  std::size_t size() const;

 private:
  using Effects = std::vector<std::string>;
  using Known = std::vector<KnownSize>;

  SessionChange m_change;
  std::vector<JournalEntry> m_journal;                                        ///< new entries
  std::variant<std::monostate, Session, std::string, Effects, Known> m_news;  ///< but of rows
};

}  // namespace alidade::ui
