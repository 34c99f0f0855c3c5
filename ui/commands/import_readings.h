#pragma once

#include <vector>

#include "core/session/session.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Replaces the current session by one with imported readings, keeping file and journal; the journal states
/// the origin of the rows.
class ImportReadings : public JournalledCommand {
 public:
  ImportReadings(SessionDocument& document, Session session, std::vector<JournalEntry> origins,
                 const QString& text);

 private:
  void apply() override;
  std::vector<JournalEntry> allEntries() const override { return m_origins; }

  Session m_other;  ///< the session not in use; its journal is ignored
  std::vector<JournalEntry> m_origins;
};

}  // namespace alidade::ui
