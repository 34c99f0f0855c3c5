#pragma once

#include <vector>

#include "core/session/session.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Puts a session with imported readings in the place of the one at work, whose file and journal stay: the
/// journal tells from where the rows came.
class ImportReadings : public JournalledCommand {
 public:
  ImportReadings(SessionDocument& document, Session session, std::vector<JournalEntry> origins,
                 const QString& text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override { return m_origins; }

  Session m_other;  ///< the one that is not at work; its journal counts for nothing
  std::vector<JournalEntry> m_origins;
};

}  // namespace alidade::ui
