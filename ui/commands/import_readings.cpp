#include "ui/commands/import_readings.h"

#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ImportReadings::ImportReadings(SessionDocument& document, Session session, std::vector<JournalEntry> origins,
                               const QString& text)
    : JournalledCommand(document, text), m_other(std::move(session)), m_origins(std::move(origins)) {
  setEntries(m_origins);
}

void ImportReadings::apply() {
  write({}, [this](Session& session) {
    std::swap(session, m_other);
    std::swap(session.journal, m_other.journal);
  });
}

}  // namespace alidade::ui
