#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ui/commands/journalled_command.h"

namespace alidade::ui {

/// Enters in the journal why `count` entries from the index `first` on were made. Undo keeps a reason that is
/// already saved in a file.
class ExplainChange : public JournalledCommand {
 public:
  ExplainChange(SessionDocument& document, std::size_t first, std::size_t count, const std::string& reason);

 private:
  void apply() override;
  std::vector<JournalEntry> allEntries() const override { return {}; }
};

}  // namespace alidade::ui
