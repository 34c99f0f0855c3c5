#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "ui/document/reading_column.h"

namespace alidade::ui {

/// A cell of the table of one position; `row` may be the one after the last reading, where a reading is
/// appended.
struct ReadingCell {
  std::size_t row = 0;
  ReadingColumn column = ReadingColumn::Horizontal;
};

/// A text for one cell of a table.
struct NewText {
  std::size_t row = 0;
  ReadingColumn column = ReadingColumn::Horizontal;
  std::string text;  ///< of `ReadingColumn::Used`: "1", or "0" where the row is kept out of the fit
};

/// Rows from `first` on: so many before the edit, so many after it.
struct RowSpan {
  std::size_t first = 0, before = 0, after = 0;
};

/// What an edit makes different in the rows of one position, there and back, and nothing else: single texts,
/// rows that go, rows that come. Of a cell in a hundred thousand rows it holds two texts.
class ReadingsPatch {
 public:
  /// What the row's first text of the cell becomes.
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
  /// New texts for cells of `rows`, and further rows after the last. Cells elsewhere are passed over.
  ReadingsPatch(const std::vector<Reading>& rows, const std::vector<NewText>& texts,
                std::vector<Reading> appended = {});
  /// The texts of these cells go. Cells elsewhere, and those that hold none, are passed over.
  static ReadingsPatch clearing(const std::vector<Reading>& rows, const std::vector<ReadingCell>& cells);
  /// From `first` on, `inserted` takes the place of `removed` rows.
  static ReadingsPatch replacing(const std::vector<Reading>& rows, std::size_t first, std::size_t removed,
                                 const std::vector<Reading>& inserted);
  /// These rows go. Rows that are not there are passed over.
  static ReadingsPatch removing(const std::vector<Reading>& rows, const std::vector<std::size_t>& gone);

  bool isEmpty() const { return m_cells.empty() && m_gone.empty() && m_new.empty(); }
  RowSpan span() const;  ///< of `apply`; `revert` has before and after exchanged
  std::size_t cellCount() const { return m_cells.size(); }
  std::size_t rowCount() const { return m_gone.size() + m_new.size(); }  ///< held whole

  const std::vector<Cell>& cells() const { return m_cells; }  ///< of rows there before and after
  const std::vector<Row>& gone() const { return m_gone; }     ///< ascending, by their numbers before
  const std::vector<Reading>& added() const { return m_new; }
  std::size_t addedFirst() const { return m_newFirst; }  ///< number of the first of `added`
  /// The row that alone is changed or added; absent where there are several, or one goes.
  std::optional<std::size_t> onlyRow() const;

  /// Cells whose text stands keep it, the first time they are changed, as the first text of their row; where
  /// it comes back there is none any more. Before `apply`, with the same rows.
  void keepFirstTexts(const std::vector<Reading>& rows,
                      const std::function<bool(std::size_t row, ReadingColumn column)>& stands);

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
