#pragma once

#include <string>

#include "ui/commands/journalled_command.h"

namespace alidade::ui {

/// Seals the session as it stands: the journal holds who answers for it and its digest, and tells of every
/// edit from then on.
class SealSession : public JournalledCommand {
 public:
  SealSession(SessionDocument& document, const std::string& by);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override { return {m_entry}; }

  JournalEntry m_entry;
};

}  // namespace alidade::ui
