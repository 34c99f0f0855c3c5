#include "ui/panels/parts/statement_table.h"

#include <utility>

#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

std::vector<DataColumn> columnsOf(const Statement& statement, const Statement& shown) {
  std::vector<DataColumn> columns;
  for (std::size_t i = 0; i < statement.columns.size(); ++i) {
    const Statement::Column& column = statement.columns[i];
    const bool isFigure = column.role == Statement::Column::Role::Figure;
    columns.push_back(
        {.title = qText(column.title),
         .toolTip = qText(column.remark),
         .sample = {},
         .text = [&shown, i](int row) { return qText(shown.rows[static_cast<std::size_t>(row)].cells[i]); },
         .alignment = isFigure ? Qt::AlignRight : Qt::AlignLeft});
  }
  return columns;
}

}  // namespace

StatementTable::StatementTable(const Statement& columns, QWidget* parent)
    : DataTable(columnsOf(columns, m_statement), parent) {}

void StatementTable::setStatement(Statement statement) {
  m_statement = std::move(statement);
  setRows(static_cast<int>(m_statement.rows.size()));
}

}  // namespace alidade::ui
