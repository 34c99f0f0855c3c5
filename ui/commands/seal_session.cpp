#include "ui/commands/seal_session.h"

#include <QCoreApplication>

#include "ui/document/session_document.h"

namespace alidade::ui {

SealSession::SealSession(SessionDocument& document, const std::string& by)
    : JournalledCommand(document, QCoreApplication::translate("SealSession", "Seal the session")),
      m_entry(sealingEntry(document.session(), by, {})) {
  setEntries({m_entry});
}

void SealSession::apply() {
  write({.kind = SessionChange::Kind::Field, .place = {.field = "journal"}}, [](Session&) {});
}

}  // namespace alidade::ui
