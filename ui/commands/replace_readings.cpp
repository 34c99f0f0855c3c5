#include "ui/commands/replace_readings.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

std::vector<Reading> rowsOf(const SessionDocument& document, std::size_t position, std::size_t first,
                            std::size_t count) {
  const std::vector<Reading>& readings = document.session().positions.at(position).readings;
  const auto from = std::next(readings.begin(), static_cast<std::ptrdiff_t>(first));
  return {from, std::next(from, static_cast<std::ptrdiff_t>(count))};
}

}  // namespace

ReplaceReadings::ReplaceReadings(SessionDocument& document, std::size_t position, std::size_t first,
                                 std::size_t removed, std::vector<Reading> inserted, const QString& text)
    : m_document(document),
      m_position(position),
      m_first(first),
      m_before(rowsOf(document, position, first, removed)),
      m_after(std::move(inserted)) {
  setText(text);
}

void ReplaceReadings::undo() {
  m_document.putReadings(m_position, m_first, m_after.size(), m_before);
}
void ReplaceReadings::redo() {
  m_document.putReadings(m_position, m_first, m_before.size(), m_after);
}

void replaceReadings(SessionDocument& document, std::size_t position, std::size_t first, std::size_t removed,
                     const std::vector<Reading>& inserted, const QString& text) {
  if (rowsOf(document, position, first, removed) == inserted) return;
  document.push(new ReplaceReadings(document, position, first, removed, inserted, text));
}

}  // namespace alidade::ui
