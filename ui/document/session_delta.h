#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/session/session.h"
#include "ui/document/session_change.h"

namespace alidade::ui {

/// One change of a session with its new contents, to be repeated on a copy elsewhere. Shares the row patch
/// with its command, holds single texts, and the whole session only if much of it is new.
class SessionDelta {
 public:
  /// `after`: the session after `change`.
  SessionDelta(const Session& after, const SessionChange& change);

  /// Turns `session`, in its state before the change, into `after`.
  void applyTo(Session& session) const;
  /// The number of rows and cells held.
  std::size_t size() const;

 private:
  using Effects = std::vector<std::string>;
  using Known = std::vector<KnownSize>;

  SessionChange m_change;
  std::vector<JournalEntry> m_journal;                                        ///< new entries
  std::variant<std::monostate, Session, std::string, Effects, Known> m_news;  ///< except rows
};

}  // namespace alidade::ui
