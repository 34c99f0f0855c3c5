#include "ui/report/report_statement.h"

#include "ui/report/report_table.h"
#include "ui/report/report_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

using Role = Statement::Column::Role;

/// Widths in mm; remarks take what the others leave.
double widthOf(Role role) {
  constexpr double name = 62, word = 12, figure = 20;
  if (role == Role::Name) return name;
  return role == Role::Word ? word : figure;
}

QString besideFigures(const std::string& text, Role role) {
  return role == Role::Remark && !text.empty() ? QStringLiteral("  ") + qText(text) : qText(text);
}

std::vector<ReportColumn> columnsOf(const Statement& statement) {
  double rest = ReportSheet::width;
  for (const Statement::Column& column : statement.columns)
    if (column.role != Role::Remark) rest -= widthOf(column.role);
  std::vector<ReportColumn> columns;
  for (const Statement::Column& column : statement.columns) {
    const bool isLeft = column.role == Role::Name || column.role == Role::Remark;
    columns.push_back({besideFigures(column.title, column.role),
                       column.role == Role::Remark ? rest : widthOf(column.role),
                       isLeft ? Qt::AlignLeft : Qt::AlignRight});
  }
  return columns;
}

}  // namespace

void addStatement(ReportSheet& sheet, const Statement& statement) {
  constexpr double rowHeight = 4.5;  // mm, about
  sheet.keepTogether(static_cast<double>(statement.rows.size() + 3) * rowHeight);
  sheet.heading(qText(statement.title));
  ReportTable table(sheet, columnsOf(statement));
  table.head();
  for (const Statement::Row& row : statement.rows) {
    std::vector<ReportCell> cells;
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      cells.emplace_back(besideFigures(row.cells[i], statement.columns[i].role),
                         row.isTotal ? type::body.inBold() : type::body);
    table.row(cells);
  }
  table.finish();
  QStringList sentences;
  for (const std::string& sentence : statement.sentences) sentences.append(qText(sentence));
  if (!statement.note.empty()) sentences.append(qText(statement.note));
  if (!sentences.isEmpty()) sheet.paragraph(Report::sentences(sentences), type::small);
}

}  // namespace alidade::ui
