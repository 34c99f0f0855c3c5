#pragma once

#include <optional>
#include <vector>

#include "core/session/session.h"
#include "ui/document/session_delta.h"

namespace alidade::ui {

/// A session to be evaluated: as a whole, or by what is new since one that was evaluated before. The window's
/// thread copies what an edit made new and no more; the whole is put together where it is evaluated.
class FitRequest {
 public:
  explicit FitRequest(const Session& whole) : m_whole(whole), m_held(rowsOf(whole)) {}
  /// `session` as `change` has left it.
  FitRequest(const Session& session, const SessionChange& change);

  /// A further change of the session.
  void add(const Session& session, const SessionChange& change);
  bool isWhole() const { return m_whole.has_value(); }
  /// What the request makes of the session before it, which matters not where it is whole.
  Session onto(Session before) const;

 private:
  static std::size_t rowsOf(const Session& session);

  std::optional<Session> m_whole;
  std::vector<SessionDelta> m_deltas;
  std::size_t m_held = 0;  ///< rows and cells of rows in all
};

}  // namespace alidade::ui
