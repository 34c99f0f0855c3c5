#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/session/session.h"
#include "ui/document/reading_column.h"

namespace alidade::ui {

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
  ReadingsPatch() = default;
  /// New texts for cells of `rows`, and further rows after the last. Cells elsewhere are passed over.
  ReadingsPatch(const std::vector<Reading>& rows, const std::vector<NewText>& texts,
                std::vector<Reading> appended = {});
  /// From `first` on, `inserted` takes the place of `removed` rows.
  static ReadingsPatch replacing(const std::vector<Reading>& rows, std::size_t first, std::size_t removed,
                                 const std::vector<Reading>& inserted);
  /// These rows go. Rows that are not there are passed over.
  static ReadingsPatch removing(const std::vector<Reading>& rows, const std::vector<std::size_t>& gone);

  bool isEmpty() const { return m_cells.empty() && m_gone.empty() && m_new.empty(); }
  RowSpan span() const;  ///< of `apply`; `revert` has before and after exchanged
  std::size_t cellCount() const { return m_cells.size(); }
  std::size_t rowCount() const { return m_gone.size() + m_new.size(); }  ///< held whole

  void apply(std::vector<Reading>& rows) const;
  void revert(std::vector<Reading>& rows) const;

 private:
  struct Cell {
    std::size_t row = 0;
    ReadingColumn column = ReadingColumn::Horizontal;
    std::string before, after;
  };
  struct Row {
    std::size_t index = 0;
    Reading reading;
  };

  void addCell(const std::vector<Reading>& rows, const NewText& text);
  void eraseGone(std::vector<Reading>& rows) const;
  void bringBackGone(std::vector<Reading>& rows) const;

  std::vector<Cell> m_cells;   ///< of rows that are there before and after, by the same number
  std::vector<Row> m_gone;     ///< ascending, by their numbers before
  std::size_t m_newFirst = 0;  ///< number of the first of
  std::vector<Reading> m_new;
};

}  // namespace alidade::ui
