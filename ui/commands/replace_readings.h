#pragma once

#include <QUndoCommand>
#include <cstddef>
#include <vector>

#include "core/session/session.h"

namespace alidade::ui {

class SessionDocument;

/// Puts `inserted` in the place of the `removed` rows from `first` on. Serves every edit of a table: typing a
/// cell, inserting, deleting, pasting, excluding.
class ReplaceReadings : public QUndoCommand {
 public:
  ReplaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                  std::vector<Reading> inserted, const QString& text);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  std::size_t m_position, m_first;
  std::vector<Reading> m_before, m_after;
};

/// Does nothing where the rows are the same as those they would replace.
void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text);

}  // namespace alidade::ui
