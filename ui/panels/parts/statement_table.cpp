#include "ui/panels/parts/statement_table.h"

#include <algorithm>
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
  fitCells();
}

void StatementTable::fitCells() {
  constexpr std::size_t rowsMeasured = 200;
  constexpr int widest = 340, margin = 14;
  DataTable::fitCells();
  for (std::size_t i = 0; i < m_statement.columns.size(); ++i) {
    int width = columnWidth(static_cast<int>(i)) - margin;
    for (std::size_t row = 0; row < std::min(rowsMeasured, m_statement.rows.size()); ++row)
      width = std::max(width, fontMetrics().horizontalAdvance(qText(m_statement.rows[row].cells[i])));
    setColumnWidth(static_cast<int>(i), std::min(width, widest) + margin);
  }
}

}  // namespace alidade::ui
