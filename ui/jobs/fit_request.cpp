#include "ui/jobs/fit_request.h"

#include <utility>

namespace alidade::ui {

FitRequest::FitRequest(const Session& session, const SessionChange& change) {
  add(session, change);
}

/// Many accumulated changes may be larger than the session itself.
void FitRequest::add(const Session& session, const SessionChange& change) {
  constexpr std::size_t fewDeltas = 1000;
  const std::size_t most = rowsOf(session) + (m_whole ? rowsOf(*m_whole) : 0) + fewDeltas;
  const bool isMuch = m_held > most || m_deltas.size() > most;
  if (isMuch || change.kind == SessionChange::Kind::Everything) {
    *this = FitRequest(session);
    return;
  }
  m_deltas.emplace_back(session, change);
  m_held += m_deltas.back().size();
}

Session FitRequest::onto(Session before) const {
  Session session = std::move(before);
  if (m_whole) session = *m_whole;
  for (const SessionDelta& delta : m_deltas) delta.applyTo(session);
  return session;
}

std::size_t FitRequest::rowsOf(const Session& session) {
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  return rows;
}

}  // namespace alidade::ui
