#include "ui/commands/replace_readings.h"

#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

ReplaceReadings::ReplaceReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch,
                                 const QString& text)
    : m_document(document), m_position(position), m_patch(std::move(patch)) {
  setText(text);
}

void ReplaceReadings::undo() {
  m_document.revertReadings(m_position, m_patch);
}
void ReplaceReadings::redo() {
  m_document.patchReadings(m_position, m_patch);
}

void patchReadings(SessionDocument& document, std::size_t position, ReadingsPatch patch,
                   const QString& text) {
  if (patch.isEmpty()) return;
  document.push(new ReplaceReadings(document, position, std::move(patch), text));
}

void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text) {
  const std::vector<Reading>& rows = document.session().positions.at(position).readings;
  patchReadings(document, position, ReadingsPatch::replacing(rows, first, removed, inserted), text);
}

}  // namespace alidade::ui
