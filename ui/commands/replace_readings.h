#pragma once

#include <cstddef>
#include <vector>

#include "ui/commands/journalled_command.h"
#include "ui/document/readings_patch.h"

namespace alidade::ui {

class SessionDocument;

/// Applies a patch to the rows of one position, for every edit of a table: typing, inserting, deleting,
/// pasting, excluding. Stores only the patch, so that memory grows with the changes, not with the rows.
class ReplaceReadings : public JournalledCommand {
 public:
  ReplaceReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch, const QString& text,
                  const char* why);

 private:
  void apply() override;
  void revert() override;
  std::vector<JournalEntry> allEntries() const override;
  SessionChange change(bool isReverted) const;

  std::size_t m_position;
  ReadingsPatch m_patch;
  const char* m_why;
};

/// Pushes the patch as one undo step, unless the patch is empty. `why`: one of `journal_reasons`.
void patchReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch, const QString& text,
                   const char* why);

/// Replaces the `removed` rows from `first` on by `inserted`.
void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text, const char* why);

}  // namespace alidade::ui
