#include "ui/panels/parts/data_table.h"

#include <QHeaderView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QToolTip>
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "ui/commands/reading_block.h"
#include "ui/settings/window_font.h"
#include "ui/text/accessible_place.h"

namespace alidade::ui {

DataModel::DataModel(std::vector<DataColumn> columns, QObject* parent)
    : QAbstractTableModel(parent), m_columns(std::move(columns)) {}

void DataModel::setRows(int rows) {
  if (rows != m_rows) {
    beginResetModel();
    m_rows = rows;
    endResetModel();
  } else if (rows > 0) {
    emit dataChanged(index(0, 0), index(rows - 1, columnCount() - 1));
  }
}

int DataModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : m_rows;
}

int DataModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant DataModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const DataColumn& column = m_columns[static_cast<std::size_t>(index.column())];
  if (role == Qt::TextAlignmentRole) return QVariant(column.alignment | Qt::AlignVCenter);
  if (role == Qt::AccessibleTextRole) return accessibleCell(column.text(index.row()), column.title);
  return role == Qt::DisplayRole ? column.text(index.row()) : QVariant();
}

QVariant DataModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return {};
  const DataColumn& column = m_columns[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return column.title;
  return role == Qt::ToolTipRole ? column.toolTip : QVariant();
}

DataTable::DataTable(std::vector<DataColumn> columns, QWidget* parent)
    : QTableView(parent), m_model(std::move(columns)) {
  setModel(&m_model);
  setSelectionBehavior(SelectRows);
  setAlternatingRowColors(true);
  setWordWrap(false);
  setTabKeyNavigation(false);
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(36);
  horizontalHeader()->setDefaultAlignment(Qt::Alignment(Qt::AlignCenter | Qt::TextWordWrap));
  layOutByFont(*this, [this] { fitCells(); });
  connect(this, &QTableView::clicked, this,
          [this](const QModelIndex& index) { emit rowActivated(index.row()); });
  connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this] {
    if (m_isFitting) return;
    m_isFitted = false;
    wrapTitles();
  });
}

void DataTable::setRows(int rows) {
  m_model.setRows(rows);
  if (isVisible()) fitAgain();
}

/// Fits the columns to the rows that were set while another page was in front.
void DataTable::showEvent(QShowEvent* event) {
  QTableView::showEvent(event);
  fitAgain();
}

void DataTable::fitAgain() {
  if (m_isFitted) fitCells();
}

void DataTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) fitAgain();
}

/// The width of the first cells of a column, or that of the longest word of its title if that is larger.
int DataTable::shownWidth(int column) const {
  constexpr int mostRows = 200;
  const DataColumn& shown = m_model.columns()[static_cast<std::size_t>(column)];
  int width = 0;
  for (const QString& word : shown.title.split(u' '))
    width = std::max(width, fontMetrics().horizontalAdvance(word));
  for (int row = 0; row < std::min(mostRows, m_model.rowCount()); ++row)
    width = std::max(width, fontMetrics().horizontalAdvance(shown.text(row)));
  return width;
}

void DataTable::fitCells() {
  constexpr int padding = 14, widest = 340;
  const QScopedValueRollback fitting(m_isFitting, true);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
  std::vector<int> widths, titles, samples, shown;
  for (int i = 0; i < m_model.columnCount(); ++i) {
    const DataColumn& column = m_model.columns()[static_cast<std::size_t>(i)];
    titles.push_back(padding + fontMetrics().horizontalAdvance(column.title));
    samples.push_back(std::max(titles.back(), padding + fontMetrics().horizontalAdvance(column.sample)));
    shown.push_back(m_model.rowCount() > 0 ? padding + shownWidth(i) : samples.back());
    widths.push_back(std::min(shown.back(), column.sample.isEmpty() ? padding + widest : samples.back()));
  }
  for (const std::vector<int>& wanted : {titles, shown, samples}) widen(widths, wanted);
  for (int i = 0; i < m_model.columnCount(); ++i) setColumnWidth(i, widths[static_cast<std::size_t>(i)]);
  wrapTitles();
}

/// Makes the header as high as the titles that are wrapped in their columns.
void DataTable::wrapTitles() {
  constexpr int margins = 8;
  int height = 0;
  for (int i = 0; i < m_model.columnCount(); ++i) {
    const QRect room(0, 0, columnWidth(i) - margins, QWIDGETSIZE_MAX);
    const QString& title = m_model.columns()[static_cast<std::size_t>(i)].title;
    height = std::max(height, fontMetrics().boundingRect(room, Qt::TextWordWrap, title).height());
  }
  if (horizontalHeader()->minimumHeight() == height + margins) return;
  horizontalHeader()->setMinimumHeight(height + margins);
  updateGeometries();
}

/// Distributes the free width among the columns that are narrower than wanted, from the first on.
void DataTable::widen(std::vector<int>& widths, const std::vector<int>& wanted) const {
  int room = viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const int more = std::clamp(wanted[i] - widths[i], 0, std::max(room, 0));
    widths[i] += more;
    room -= more;
  }
}

void DataTable::setPlaceholder(const QString& text) {
  m_placeholder = text;
  viewport()->update();
}

void DataTable::selectDataRows(const std::vector<int>& rows) {
  if (rows.empty()) return clearSelection();
  QItemSelection selection;
  for (const int row : rows)
    selection.select(m_model.index(row, 0), m_model.index(row, m_model.columnCount() - 1));
  selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
  selectionModel()->setCurrentIndex(m_model.index(rows.front(), 0), QItemSelectionModel::NoUpdate);
  scrollTo(m_model.index(rows.front(), 0));
}

void DataTable::copy() const {
  ReadingBlock block;
  QModelIndexList rows = selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  for (const QModelIndex& row : rows) {
    QStringList cells;
    for (const DataColumn& column : m_model.columns()) cells.append(column.text(row.row()));
    block.append(cells);
  }
  if (!block.isEmpty()) copyBlock(blockText(block));
}

void DataTable::paintEvent(QPaintEvent* event) {
  QTableView::paintEvent(event);
  if (m_model.rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                   m_placeholder);
}

/// The tool tip shows the whole of a truncated text.
bool DataTable::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QTableView::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QModelIndex cell = indexAt(help->pos());
  const bool isShortened = cell.isValid() && sizeHintForIndex(cell).width() > columnWidth(cell.column());
  QToolTip::showText(help->globalPos(), isShortened ? cell.data().toString() : QString(), viewport());
  return true;
}

void DataTable::keyPressEvent(QKeyEvent* event) {
  const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->matches(QKeySequence::Copy)) {
    copy();
  } else if (isReturn && currentIndex().isValid()) {
    emit rowActivated(currentIndex().row());
  } else {
    QTableView::keyPressEvent(event);
  }
}

}  // namespace alidade::ui
