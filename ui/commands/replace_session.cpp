#include "ui/commands/replace_session.h"

#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceSession::ReplaceSession(SessionDocument& document, Session session, const QString& text)
    : m_document(document), m_other(std::move(session)), m_otherState(JournalKeeper::stateOf(m_other, true)) {
  setText(text);
}

void ReplaceSession::undo() {
  m_document.exchangeSession(m_other, m_otherState);
}
void ReplaceSession::redo() {
  m_document.exchangeSession(m_other, m_otherState);
}

}  // namespace alidade::ui
