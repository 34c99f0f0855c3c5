#pragma once

#include "core/statement/statement.h"
#include "ui/panels/parts/data_table.h"

namespace alidade::ui {

/// Shows the table of a statement with many rows or columns: selected by rows, copied for a spreadsheet, the
/// remarks on its columns as tool tips.
class StatementTable : public DataTable {
  Q_OBJECT

 public:
  /// `columns` has the columns that every later statement has.
  explicit StatementTable(const Statement& columns, QWidget* parent = nullptr);

  void setStatement(Statement statement);

 private:
  Statement m_statement;
};

}  // namespace alidade::ui
