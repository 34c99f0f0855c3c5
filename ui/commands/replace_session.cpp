#include "ui/commands/replace_session.h"

#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceSession::ReplaceSession(SessionDocument& document, Session session, File file, const QString& text)
    : m_document(document), m_before(document.session()), m_after(std::move(session)), m_file(file) {
  setText(text);
}

void ReplaceSession::undo() {
  put(m_before);
}
void ReplaceSession::redo() {
  put(m_after);
}

/// Either session may have been saved elsewhere meanwhile: its path is taken along as it is left.
void ReplaceSession::put(const Session& session) {
  const QString path = m_document.path();
  m_document.putSession(session, m_file == File::None ? std::exchange(m_otherPath, path) : path);
}

}  // namespace alidade::ui
