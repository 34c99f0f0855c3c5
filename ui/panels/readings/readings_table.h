#pragma once

#include <QTableView>
#include <vector>

#include "ui/commands/edit_readings.h"
#include "ui/models/readings_model.h"

namespace alidade::ui {

class ReadingDelegate;

/// The table of one position, made for the bench: typing overwrites, Enter and Tab hand in and go onward from
/// horizontal to vertical to the next row, blocks are copied from and pasted to spreadsheets. Every edit is
/// one undo step.
class ReadingsTable : public QTableView {
  Q_OBJECT

 public:
  ReadingsTable(SessionDocument& document, std::size_t position, QWidget* parent = nullptr);

  ReadingsModel& readings() { return m_model; }
  void setColumnShown(ReadingColumn column, bool shown);  ///< a column in use stays shown
  void selectCell(int row, ReadingColumn column);
  void commitOpenEditor();

  void copy() const;
  void cut();
  void paste();
  void clearCells();
  void insertAbove();
  void deleteSelected();
  void
  toggleExcluded();  ///< uses the selected rows where the first of them is excluded, otherwise excludes them

 signals:
  void rowEntered(std::size_t row);  ///< the current cell came to another row with a reading
  void remark(const QString& text);  ///< for the status line

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  bool handleEditKey(const QKeyEvent* event);
  void goTo(const QModelIndex& cell);
  void goOnward(int key);
  QModelIndex onward(const QModelIndex& from, int key) const;
  QModelIndex neighbour(const QModelIndex& from, int step) const;
  std::vector<std::size_t> selectedRows() const;
  std::vector<ReadingCell> selectedCells() const;
  std::vector<ReadingColumn> columnsFrom(int column) const;
  void layOutColumns();
  int widthOf(const char* sample) const;
  void showUsedColumns();
  void showColumnsUsedBy(const SessionChange& change);
  void fitAngles();

  ReadingsModel m_model;
  ReadingsEditor m_editor;
  ReadingDelegate* m_delegate;
  std::vector<ReadingColumn> m_wanted;  ///< optional columns the user asked for
  bool m_isFitting = false;             ///< widths are being set here
  bool m_isFitted = true;               ///< not by the user
};

}  // namespace alidade::ui
