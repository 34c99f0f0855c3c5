#pragma once

#include "core/statement/statement.h"
#include "ui/panels/parts/data_table.h"

namespace alidade::ui {

/// Shows the table of a statement with many rows or columns. Rows can be selected and copied for a
/// spreadsheet; tool tips show the remarks on the columns.
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
