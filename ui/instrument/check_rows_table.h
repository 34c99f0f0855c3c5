#pragma once

#include "ui/instrument/check_rows_model.h"
#include "ui/panels/parts/entry_table.h"

namespace alidade::ui {

/// The table to type or paste rounds into.
class CheckRowsTable : public EntryTable {
  Q_OBJECT

 public:
  explicit CheckRowsTable(QWidget* parent = nullptr);

  CheckRowsModel& rows() { return m_model; }

  void copy() const override;
  void cut() override;
  void paste() override;
  void clearCells() override;

 protected:
  QModelIndex onward(const QModelIndex& from, int key) const override;
  QModelIndex firstCell() const override { return m_model.index(0, 2); }

 private:
  CheckRowsModel m_model;
};

}  // namespace alidade::ui
