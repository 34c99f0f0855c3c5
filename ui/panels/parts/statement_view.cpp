#include "ui/panels/parts/statement_view.h"

#include <QLabel>
#include <QVBoxLayout>

#include "ui/panels/parts/figure_grid.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

using Role = Statement::Column::Role;

FigureGrid::Row gridRow(const Statement& statement, const Statement::Row& row) {
  FigureGrid::Row shown{.caption = qText(row.cells.front()), .figures = {}};
  for (std::size_t i = 1; i < row.cells.size(); ++i) {
    const Statement::Column& column = statement.columns[i];
    if (column.role != Role::Remark)
      shown.figures.append(qText(row.cells[i]));
    else if (row.isTotal || column.title.empty() || row.cells[i].empty())
      shown.toolTip = qText(row.cells[i]);
    else
      shown.toolTip = StatementView::tr("%1: %2").arg(qText(column.title), qText(row.cells[i]));
  }
  return shown;
}

}  // namespace

StatementView::StatementView(QWidget* parent)
    : QWidget(parent),
      m_title(panelHeading({})),
      m_grid(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_note(wrappedLabel()) {
  m_note->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  for (QWidget* part : std::initializer_list<QWidget*>{m_title, m_grid, m_note}) layout->addWidget(part);
  hide();
}

void StatementView::setStatement(const std::optional<Statement>& statement) {
  setEnabled(true);
  setVisible(statement.has_value());
  if (!statement) return;
  m_title->setText(qText(statement->title));
  QStringList titles, notes;
  for (const Statement::Column& column : statement->columns)
    if (column.role != Role::Remark && column.role != Role::Name) titles.append(qText(column.title));
  QVector<FigureGrid::Row> rows;
  for (const Statement::Row& row : statement->rows) rows.append(gridRow(*statement, row));
  m_grid->setRows(titles, rows);
  if (!statement->note.empty()) notes.append(qText(statement->note));
  for (const std::string& sentence : statement->sentences) notes.append(qText(sentence));
  m_note->setText(notes.join(u'\n'));
  m_note->setVisible(!notes.isEmpty());
}

}  // namespace alidade::ui
