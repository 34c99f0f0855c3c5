#include "ui/commands/replace_session.h"

#include <utility>

namespace alidade::ui {

ReplaceSession::ReplaceSession(SessionDocument& document, Session session, const QString& text)
    : SessionCommand(document, text),
      m_other(std::move(session)),
      m_otherState(JournalKeeper::stateOf(m_other, true)) {}

void ReplaceSession::exchange() {
  edit({}, [this](Session& session) {
    std::swap(session, m_other);
    journal().exchange(m_otherState);
  });
}

}  // namespace alidade::ui
