#include "ui/panels/parts/statement_view.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "ui/panels/parts/figure_grid.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

using Role = Statement::Column::Role;

FigureGrid::Row gridRow(const Statement& statement, const Statement::Row& row) {
  FigureGrid::Row shown{.caption = qText(row.cells.front()),
                        .figures = {},
                        .toolTip = qText(row.about),
                        .isPart = row.isPart,
                        .isBold = row.isNotable,
                        .bar = row.bar};
  for (const std::string& text : statement.textsBelow(row)) shown.below.append(qText(text));
  for (std::size_t i = 1; i < row.cells.size(); ++i) {
    const Statement::Column& column = statement.columns[i];
    if (column.role == Role::Text) continue;
    if (column.role != Role::Remark)
      shown.figures.append(qText(row.cells[i]));
    else if (row.isTotal || column.title.empty() || row.cells[i].empty())
      shown.toolTip = qText(row.cells[i]);
    else
      shown.toolTip = StatementView::tr("%1: %2").arg(qText(column.title), qText(row.cells[i]));
  }
  return shown;
}

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

StatementView::StatementView(QWidget* parent)
    : QWidget(parent),
      m_title(panelHeading({})),
      m_grid(new FigureGrid(nullptr, FigureGrid::Captions::Wrapped)),
      m_sentences(wrappedLabel()),
      m_note(wrappedLabel()) {
  m_title->setWordWrap(true);
  m_note->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  for (QWidget* part : std::initializer_list<QWidget*>{m_title, m_grid, m_sentences, m_note})
    layout->addWidget(part);
  connect(m_grid, &FigureGrid::ticksChanged, this, &StatementView::ticksChanged);
  hide();
}

void StatementView::setTicks(TickOf tickOf) {
  m_tickOf = std::move(tickOf);
}

QStringList StatementView::ticked() const {
  return m_grid->ticked();
}

void StatementView::setStatement(const std::optional<Statement>& statement) {
  setEnabled(true);
  setVisible(statement && (!statement->rows.empty() || !statement->sentences.empty()));
  if (isHidden()) return;
  m_title->setText(qText(statement->title));
  QStringList titles, sentences;
  int barColumn = -1;
  for (const Statement::Column& column : statement->columns) {
    if (column.role == Role::Remark || column.role == Role::Name || column.role == Role::Text) continue;
    if (column.role == Role::Bar) barColumn = static_cast<int>(titles.size());
    titles.append(qText(column.title));
  }
  QVector<FigureGrid::Row> rows;
  for (const Statement::Row& row : statement->rows) {
    rows.append(gridRow(*statement, row));
    const auto tick = m_tickOf && !row.id.empty() ? m_tickOf(row.id) : std::nullopt;
    if (!tick) continue;
    rows.back().tick = qText(row.id);
    rows.back().isTicked = *tick;
  }
  m_grid->setRows(titles, rows, barColumn);
  for (const std::string& sentence : statement->sentences) sentences.append(qText(sentence));
  m_title->setVisible(!statement->title.empty());
  m_grid->setVisible(!rows.isEmpty());
  for (const auto& [label, text] :
       {std::pair(m_sentences, sentences.join(u'\n')), std::pair(m_note, qText(statement->note))}) {
    label->setText(text);
    label->setVisible(!text.isEmpty());
  }
}

StatementTable::StatementTable(const Statement& columns, QWidget* parent)
    : DataTable(columnsOf(columns, m_statement), parent) {}

void StatementTable::setStatement(Statement statement) {
  m_statement = std::move(statement);
  setRows(static_cast<int>(m_statement.rows.size()));
}

}  // namespace alidade::ui
