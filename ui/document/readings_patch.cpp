#include "ui/document/readings_patch.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace alidade::ui {

namespace {

auto at(std::vector<Reading>& rows, std::size_t row) {
  return std::next(rows.begin(), static_cast<std::ptrdiff_t>(row));
}

}  // namespace

ReadingsPatch::ReadingsPatch(const std::vector<Reading>& rows, const std::vector<NewText>& texts,
                             std::vector<Reading> appended)
    : m_newFirst(rows.size()), m_new(std::move(appended)) {
  m_cells.reserve(texts.size());
  for (const NewText& text : texts) addCell(rows, text);
}

ReadingsPatch ReadingsPatch::replacing(const std::vector<Reading>& rows, std::size_t first,
                                       std::size_t removed, const std::vector<Reading>& inserted) {
  ReadingsPatch patch;
  const std::size_t kept = std::min(removed, inserted.size());
  for (std::size_t i = 0; i < kept; ++i)
    for (int column = 0; column < readingColumnCount; ++column)
      if (const auto entered = static_cast<ReadingColumn>(column); isEntered(entered))
        patch.addCell(rows, {first + i, entered, enteredText(inserted[i], entered)});
  for (std::size_t row = first + kept; row < first + removed; ++row) patch.m_gone.push_back({row, rows[row]});
  patch.m_newFirst = first + kept;
  patch.m_new.assign(std::next(inserted.begin(), static_cast<std::ptrdiff_t>(kept)), inserted.end());
  return patch;
}

ReadingsPatch ReadingsPatch::clearing(const std::vector<Reading>& rows,
                                      const std::vector<ReadingCell>& cells) {
  ReadingsPatch patch;
  patch.m_cells.reserve(cells.size());
  for (const auto& [row, column] : cells)
    if (readingText(column)) patch.addCell(rows, {row, column, {}});
  return patch;
}

ReadingsPatch ReadingsPatch::removing(const std::vector<Reading>& rows,
                                      const std::vector<std::size_t>& gone) {
  std::vector<std::size_t> numbers = gone;
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  ReadingsPatch patch;
  for (const std::size_t row : numbers)
    if (row < rows.size()) patch.m_gone.push_back({row, rows[row]});
  return patch;
}

void ReadingsPatch::addCell(const std::vector<Reading>& rows, const NewText& text) {
  if (text.row >= rows.size()) return;
  if (const auto typed = readingText(text.column); typed && rows[text.row].*typed == text.text) return;
  std::string before = enteredText(rows[text.row], text.column);
  if (before != text.text)
    m_cells.push_back({text.row, text.column, First::Untouched, std::move(before), text.text});
}

RowSpan ReadingsPatch::span() const {
  std::size_t first = m_gone.empty() ? m_newFirst : m_gone.front().index;
  std::size_t end = m_gone.empty() ? (m_new.empty() ? 0 : m_newFirst) : m_gone.back().index + 1;
  if (m_gone.empty() && m_new.empty() && !m_cells.empty()) first = m_cells.front().row;
  for (const Cell& cell : m_cells) {
    first = std::min(first, cell.row);
    end = std::max(end, cell.row + 1);
  }
  const std::size_t before = end - std::min(first, end);
  return {first, before, before + m_new.size() - m_gone.size()};
}

std::optional<std::size_t> ReadingsPatch::onlyRow() const {
  if (m_cells.empty() && m_new.empty()) return std::nullopt;
  const RowSpan changed = span();
  const bool isOne = m_gone.empty() && m_new.size() <= 1 && changed.before + m_new.size() <= 1;
  return isOne ? std::optional(changed.first) : std::nullopt;
}

void ReadingsPatch::keepFirstTexts(
    const std::vector<Reading>& rows,
    const std::function<bool(std::size_t row, ReadingColumn column)>& isRecorded) {
  for (Cell& cell : m_cells) {
    if (!readingText(cell.column) || isFreeText(cell.column)) continue;
    const auto first = rows[cell.row].asRead.of(infoOf(cell.column).field->key);
    if (!first && !cell.before.empty() && isRecorded(cell.row, cell.column))
      cell.first = First::Kept;
    else if (first == cell.after)
      cell.first = First::Dropped;
  }
}

void ReadingsPatch::apply(std::vector<Reading>& rows) const {
  for (const Cell& cell : m_cells) {
    enter(rows[cell.row], cell.column, cell.after);
    if (cell.first == First::Untouched) continue;
    const std::string_view field = infoOf(cell.column).field->key;
    FirstTexts& texts = rows[cell.row].asRead;
    cell.first == First::Kept ? texts.set(field, cell.before) : texts.drop(field);
  }
  eraseGone(rows);
  rows.insert(at(rows, std::min(m_newFirst, rows.size())), m_new.begin(), m_new.end());
}

void ReadingsPatch::revert(std::vector<Reading>& rows) const {
  if (!m_new.empty()) rows.erase(at(rows, m_newFirst), at(rows, m_newFirst + m_new.size()));
  bringBackGone(rows);
  for (const Cell& cell : m_cells) {
    enter(rows[cell.row], cell.column, cell.before);
    if (cell.first == First::Untouched) continue;
    const std::string_view field = infoOf(cell.column).field->key;
    FirstTexts& texts = rows[cell.row].asRead;
    cell.first == First::Kept ? texts.drop(field) : texts.set(field, cell.after);
  }
}

void ReadingsPatch::eraseGone(std::vector<Reading>& rows) const {
  if (m_gone.empty()) return;
  auto next = m_gone.begin();
  std::size_t to = next->index;
  for (std::size_t from = to; from < rows.size(); ++from) {
    if (next != m_gone.end() && next->index == from) {
      ++next;
    } else {
      rows[to++] = std::move(rows[from]);
    }
  }
  rows.resize(to);
}

/// Inserts from the end backwards, so that each row moves once.
void ReadingsPatch::bringBackGone(std::vector<Reading>& rows) const {
  std::size_t from = rows.size();
  rows.resize(rows.size() + m_gone.size());
  auto next = m_gone.rbegin();
  for (std::size_t to = rows.size(); next != m_gone.rend(); --to) {
    if (next->index == to - 1) {
      rows[to - 1] = next->reading;
      ++next;
    } else {
      rows[to - 1] = std::move(rows[--from]);
    }
  }
}

}  // namespace alidade::ui
