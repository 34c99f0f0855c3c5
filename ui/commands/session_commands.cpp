#include "ui/commands/session_commands.h"

#include <QCoreApplication>
#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceSession::ReplaceSession(SessionDocument& document, Session session, const QString& text, bool isNew)
    : SessionCommand(document, text),
      m_other(std::move(session)),
      m_otherState(JournalKeeper::stateOf(m_other, isNew)) {}

void ReplaceSession::exchange() {
  edit({}, [this](Session& session) {
    std::swap(session, m_other);
    journal().exchange(m_otherState);
  });
}

ImportReadings::ImportReadings(SessionDocument& document, Session session, std::vector<JournalEntry> origins,
                               const QString& text)
    : JournalledCommand(document, text), m_other(std::move(session)), m_origins(std::move(origins)) {
  setEntries(m_origins);
}

void ImportReadings::apply() {
  edit({}, [this](Session& session) {
    std::swap(session, m_other);
    std::swap(session.journal, m_other.journal);
  });
}

SealSession::SealSession(SessionDocument& document, const std::string& by)
    : JournalledCommand(document, QCoreApplication::translate("SealSession", "Seal the session")),
      m_entry(sealingEntry(document.session(), by, {})) {
  setEntries({m_entry});
}

void SealSession::apply() {
  edit({.kind = SessionChange::Kind::Field, .place = {.field = "journal"}}, [](Session&) {});
}

}  // namespace alidade::ui
