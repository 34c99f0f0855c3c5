#pragma once

#include <QUndoCommand>
#include <cstddef>
#include <vector>

#include "ui/document/readings_patch.h"

namespace alidade::ui {

class SessionDocument;

/// Makes a patch of the rows of one position. Serves every edit of a table: typing a cell, inserting,
/// deleting, pasting, excluding. Holds the patch alone, so that ten thousand steps weigh no more than what
/// they changed.
class ReplaceReadings : public QUndoCommand {
 public:
  ReplaceReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch, const QString& text);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  std::size_t m_position;
  ReadingsPatch m_patch;
};

/// Does nothing where the patch changes nothing.
void patchReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch, const QString& text);

/// Puts `inserted` in the place of the `removed` rows from `first` on.
void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text);

}  // namespace alidade::ui
