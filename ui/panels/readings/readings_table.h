#pragma once

#include <vector>

#include "ui/commands/edit_readings.h"
#include "ui/document/half_typed.h"
#include "ui/models/readings_model.h"
#include "ui/panels/parts/entry_table.h"

namespace alidade::ui {

class ReasonLine;

/// The readings of one position, for entry at the bench: Enter and Tab move from horizontal to vertical to
/// the next row. Blocks are copied to and pasted from spreadsheets.
class ReadingsTable : public EntryTable {
  Q_OBJECT

 public:
  ReadingsTable(SessionDocument& document, std::size_t position, QWidget* parent = nullptr);

  ReadingsModel& readings() { return m_model; }
  void setColumnShown(ReadingColumn column, bool shown);  ///< a column in use stays shown
  void selectCell(int row, ReadingColumn column);
  std::vector<std::size_t> selectedRows() const;  ///< ascending, rows with a reading only
  /// Makes the first missing horizontal or vertical cell current. If all rows are complete, this is a cell of
  /// the empty last row.
  void goToNextEntry();

  void copy() const override;
  void cut() override;
  void paste() override;
  void clearCells() override;
  void insertAbove();
  void layOut(FurtherRows which);
  void deleteSelected();
  /// Asks in place for the reason of excluded rows (ascending), which becomes their note.
  void askReason(const std::vector<std::size_t>& rows);
  /// Accepts a reason that is being typed.
  void commitReason();
  void toggleExcluded();  ///< includes the selected rows if the first is excluded, otherwise excludes them

 signals:
  void rowEntered(std::size_t row);  ///< the current cell moved to another row with a reading

 protected:
  bool handleEditKey(const QKeyEvent* event) override;
  QModelIndex onward(const QModelIndex& from, int key) const override;
  QModelIndex firstCell() const override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::vector<ReadingCell> selectedCells() const;
  std::vector<ReadingColumn> columnsFrom(int column) const;
  void layOutColumns();
  void fitCells();
  int widthOf(const char* sample) const;
  void showUsedColumns();
  void showColumnsUsedBy(const SessionChange& change);
  void fitAngles();
  QModelIndex nextEntryCell() const;
  void reportReason(HalfTyped& halfTyped);
  HalfTypedText halfTyped(const QLineEdit& editor, const QModelIndex& cell) const;

  ReadingsModel m_model;
  ReadingsEditor m_editor;
  ReasonLine* m_reason;
  std::vector<ReadingColumn> m_wanted;  ///< optional columns chosen by the user
  bool m_isFitting = false;             ///< the table itself is setting widths
  bool m_isFitted = true;               ///< false once the user sets a width
};

}  // namespace alidade::ui
