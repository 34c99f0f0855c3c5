#pragma once

#include <cstddef>
#include <vector>

#include "ui/commands/journalled_command.h"

namespace alidade::ui {

/// Removes a position with its pointing zero and all its readings.
class RemovePosition : public JournalledCommand {
 public:
  RemovePosition(SessionDocument& document, std::size_t index);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override { return m_all; }

  std::size_t m_index;
  Position m_position;
  std::vector<JournalEntry> m_all;  ///< computed while the position exists
};

/// Does nothing if there is no such position.
void removePosition(SessionDocument& document, std::size_t index);

}  // namespace alidade::ui
