#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"
#include "ui/document/session_delta.h"

namespace alidade::ui {

/// A session to evaluate: as a whole, or as changes since an earlier evaluated one. The window's thread
/// copies only new parts; the evaluating thread assembles the whole.
class FitRequest {
 public:
  explicit FitRequest(const Session& whole) : m_whole(whole), m_held(rowsOf(whole)) {}
  /// `session` after `change`.
  FitRequest(const Session& session, const SessionChange& change);

  /// A further change of the session.
  void add(const Session& session, const SessionChange& change);
  bool isWhole() const { return m_whole.has_value(); }
  /// Applies the request to the previous session, which is ignored for a whole one.
  Session onto(Session before) const;

 private:
  static std::size_t rowsOf(const Session& session);

  std::optional<Session> m_whole;
  std::vector<SessionDelta> m_deltas;
  std::size_t m_held = 0;  ///< rows and cells held in total
};

}  // namespace alidade::ui
