#pragma once

#include <string>

#include "ui/commands/journalled_command.h"

namespace alidade::ui {

/// Seals the current session: the journal records who is responsible and the digest, and lists every later
/// edit.
class SealSession : public JournalledCommand {
 public:
  SealSession(SessionDocument& document, const std::string& by);

 private:
  void apply() override;
  std::vector<JournalEntry> allEntries() const override { return {m_entry}; }

  JournalEntry m_entry;
};

}  // namespace alidade::ui
