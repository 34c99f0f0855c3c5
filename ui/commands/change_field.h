#pragma once

#include <string>

#include "core/base/place.h"
#include "ui/commands/journalled_command.h"

namespace alidade::ui {

class SessionDocument;

/// Sets one field of the session; `fieldNamed` lists the fields.
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

/// Stores a day in the session's form (`completedDay`). Does nothing if the field already has this text.
void changeField(SessionDocument& document, const Place& place, const std::string& typed);

}  // namespace alidade::ui
