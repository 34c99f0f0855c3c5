#include "ui/document/open_entries.h"

namespace alidade::ui {

namespace {

bool isZero(const Place& field) {
  return field.field.starts_with("pointing_zero.");
}

}  // namespace

void OpenEntries::close() {
  m_row.reset();
  m_zero.reset();
  m_fields.clear();
  m_isNew = false;
}

bool OpenEntries::isOpen(std::size_t position, std::size_t row, ReadingColumn column) const {
  return m_row && m_row->position == position && m_row->row == row && m_row->columns.contains(column);
}

bool OpenEntries::isOpen(const Place& field) const {
  const FieldKey key{field.field, field.position};
  return isZero(field) ? m_zero == key : m_isNew || m_fields.contains(key);
}

void OpenEntries::enter(std::size_t position, const std::vector<Reading>& rows, const ReadingsPatch& patch) {
  m_zero.reset();
  const std::optional<std::size_t> row = patch.onlyRow();
  if (!row) {
    m_row.reset();
    return;
  }
  if (!m_row || m_row->position != position || m_row->row != *row || patch.rowCount() > 0)
    m_row = Row{position, *row};
  for (int i = 0; i < readingColumnCount; ++i)
    if (const auto column = static_cast<ReadingColumn>(i);
        readingText(column) && (patch.rowCount() > 0 || (rows[*row].*readingText(column)).empty()))
      m_row->columns.insert(column);
}

void OpenEntries::enter(const Place& field, bool wasEmpty) {
  const FieldKey key{field.field, field.position};
  m_row.reset();
  if (!isZero(field)) {
    m_zero.reset();
    if (wasEmpty) m_fields.insert(key);
  } else if (wasEmpty) {
    m_zero = key;
  } else if (m_zero != key) {
    m_zero.reset();
  }
}

}  // namespace alidade::ui
