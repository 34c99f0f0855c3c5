#pragma once

#include <string>

#include "core/base/place.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Sets one field of the session; see `fieldNamed` for those there are.
class ChangeField : public JournalledCommand {
 public:
  ChangeField(SessionDocument& document, const Place& place, std::string text);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;

  Place m_place;
  std::string m_before, m_after;
};

/// A day is put as the session has it (`completedDay`). Does nothing where the field has this text already.
void changeField(SessionDocument& document, const Place& place, const std::string& typed);

}  // namespace alidade::ui
