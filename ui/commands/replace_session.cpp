#include "ui/commands/replace_session.h"

#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceSession::ReplaceSession(SessionDocument& document, Session session, const QString& text)
    : m_document(document), m_before(document.session()), m_after(std::move(session)) {
  setText(text);
}

void ReplaceSession::undo() {
  m_document.putSession(m_before);
}
void ReplaceSession::redo() {
  m_document.putSession(m_after);
}

}  // namespace alidade::ui
