#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "ui/document/reading_column.h"

namespace alidade::ui {

/// A cell of the table of one position; `row` may be the row after the last, to append a reading.
struct ReadingCell {
  std::size_t row = 0;
  ReadingColumn column = ReadingColumn::Horizontal;
};

/// A text for one cell of a table.
struct NewText {
  std::size_t row = 0;
  ReadingColumn column = ReadingColumn::Horizontal;
  std::string text;  ///< for `ReadingColumn::Used`: "1", or "0" if the row is excluded
};

/// A block of rows from `first` on: its number of rows before and after the edit.
struct RowSpan {
  std::size_t first = 0, before = 0, after = 0;
};

/// The changes of an edit to the rows of one position, in both directions: single texts, removed rows, added
/// rows. Unchanged rows are not stored, so a change of one cell stores only two texts.
class ReadingsPatch {
 public:
  /// What the edit does to the cell's first text in `Reading::asRead`.
  enum class First { Untouched, Kept, Dropped };
  struct Cell {
    std::size_t row = 0;
    ReadingColumn column = ReadingColumn::Horizontal;
    First first = First::Untouched;
    std::string before, after;
  };
  struct Row {
    std::size_t index = 0;
    Reading reading;
  };

  ReadingsPatch() = default;
  /// Sets texts in cells of `rows` and appends rows after the last. Ignores cells outside `rows`.
  ReadingsPatch(const std::vector<Reading>& rows, const std::vector<NewText>& texts,
                std::vector<Reading> appended = {});
  /// Returns a patch that clears these cells. Ignores empty cells and cells outside `rows`.
  static ReadingsPatch clearing(const std::vector<Reading>& rows, const std::vector<ReadingCell>& cells);
  /// Returns a patch in which `inserted` replaces `removed` rows from `first` on.
  static ReadingsPatch replacing(const std::vector<Reading>& rows, std::size_t first, std::size_t removed,
                                 const std::vector<Reading>& inserted);
  /// Returns a patch that removes these rows. Ignores missing rows.
  static ReadingsPatch removing(const std::vector<Reading>& rows, const std::vector<std::size_t>& gone);

  bool isEmpty() const { return m_cells.empty() && m_gone.empty() && m_new.empty(); }
  RowSpan span() const;  ///< rows that `apply` changes; `revert` changes `after` back to `before`
  std::size_t cellCount() const { return m_cells.size(); }
  std::size_t rowCount() const { return m_gone.size() + m_new.size(); }  ///< number of removed and added rows

  const std::vector<Cell>& cells() const { return m_cells; }  ///< cells in rows that the edit keeps
  const std::vector<Row>& gone() const { return m_gone; }     ///< ascending by row number before the edit
  const std::vector<Reading>& added() const { return m_new; }
  std::size_t addedFirst() const { return m_newFirst; }  ///< row number of the first of `added`
  /// The only changed or added row; absent if there are several, or if a row is removed.
  std::optional<std::size_t> onlyRow() const;

  /// Marks the first texts that `apply` keeps or drops. The first change of a recorded cell keeps its text; a
  /// change back to this text drops the kept text. Call before `apply`, with the same rows.
  void keepFirstTexts(const std::vector<Reading>& rows,
                      const std::function<bool(std::size_t row, ReadingColumn column)>& isRecorded);

  void apply(std::vector<Reading>& rows) const;
  void revert(std::vector<Reading>& rows) const;

 private:
  void addCell(const std::vector<Reading>& rows, const NewText& text);
  void eraseGone(std::vector<Reading>& rows) const;
  void bringBackGone(std::vector<Reading>& rows) const;

  std::vector<Cell> m_cells;
  std::vector<Row> m_gone;
  std::size_t m_newFirst = 0;
  std::vector<Reading> m_new;
};

}  // namespace alidade::ui
