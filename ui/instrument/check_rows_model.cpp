#include "ui/instrument/check_rows_model.h"

#include <algorithm>

#include "core/base/limits.h"
#include "core/exchange/csv_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr const char* keys[CheckRowsModel::columns] = {"station",    "round",    "point",   "face",
                                                       "horizontal", "vertical", "distance"};
constexpr int firstAngle = 4, lastAngle = 5;

QStringList blankRow() {
  QStringList row;
  for (int i = 0; i < CheckRowsModel::columns; ++i) row.append(QString());
  return row;
}

bool isBlankRow(const QStringList& row) {
  return std::all_of(row.begin(), row.end(), [](const QString& cell) { return cell.isEmpty(); });
}

}  // namespace

CheckRowsModel::CheckRowsModel(QObject* parent) : QAbstractTableModel(parent), m_rows{blankRow()} {}

TableLayout CheckRowsModel::layout() {
  TableLayout layout;
  layout.separator = ',';
  layout.headRows = 0;
  for (const char* key : keys) layout.columns.emplace_back(key);
  return layout;
}

std::string CheckRowsModel::csv() const {
  CsvText csv{"station"};  // its first line is removed below
  const std::size_t head = csv.text().size();
  for (std::size_t i = 0; i < countOfUse(); ++i) {
    for (const QString& cell : m_rows[i]) csv.typed(cell.toStdString());
    csv.endRow();
  }
  return csv.text().substr(head);
}

void CheckRowsModel::put(int row, int column, const QString& text) {
  if (column < 0 || column >= columns) return;
  while (static_cast<int>(m_rows.size()) <= row) m_rows.push_back(blankRow());
  m_rows[static_cast<std::size_t>(row)][column] = text.trimmed();
}

/// The number of rows to evaluate: all except the empty row, and a last row that lacks target or angle.
std::size_t CheckRowsModel::countOfUse() const {
  const std::size_t filled = m_rows.size() - 1;
  if (filled == 0) return 0;
  const QStringList& last = m_rows[filled - 1];
  constexpr int target = 2;
  const bool isWhole = !last[target].isEmpty() && !last[firstAngle].isEmpty() && !last[lastAngle].isEmpty();
  return isWhole ? filled : filled - 1;
}

/// Ensures exactly one empty row at the end.
void CheckRowsModel::tidy() {
  while (!m_rows.empty() && isBlankRow(m_rows.back())) m_rows.pop_back();
  m_rows.push_back(blankRow());
}

std::optional<Problem> CheckRowsModel::paste(const ReadingBlock& block, int row, int column) {
  const auto named = joinedBlock(block);
  if (named && !*named) return named->problem();
  beginResetModel();
  if (named)
    putNamed(**named, row);
  else
    for (qsizetype i = 0; i < block.size() && m_rows.size() < limits::mostRows; ++i)
      for (qsizetype j = 0; j < block[i].size(); ++j)
        put(row + static_cast<int>(i), column + static_cast<int>(j), block[i][j]);
  tidy();
  endResetModel();
  emit edited();
  return {};
}

/// Ignores columns unknown to a check.
void CheckRowsModel::putNamed(const JoinedTable& table, int row) {
  std::vector<int> into;
  for (const TableColumn& column : table.columns) {
    const auto* const known = std::find(std::begin(keys), std::end(keys), column.key());
    into.push_back(known == std::end(keys) ? -1 : static_cast<int>(known - std::begin(keys)));
  }
  for (std::size_t i = 0; i < table.rows.size() && m_rows.size() < limits::mostRows; ++i)
    for (std::size_t j = 0; j < into.size(); ++j)
      put(row + static_cast<int>(i), into[j], QString::fromStdString(table.rows[i][j]));
}

void CheckRowsModel::clear(const QModelIndexList& cells) {
  if (cells.isEmpty()) return;
  beginResetModel();
  for (const QModelIndex& cell : cells) put(cell.row(), cell.column(), {});
  std::erase_if(m_rows, isBlankRow);
  tidy();
  endResetModel();
  emit edited();
}

ReadingBlock CheckRowsModel::block() const {
  return ReadingBlock(m_rows.begin(), m_rows.end() - 1);
}

void CheckRowsModel::restore(const ReadingBlock& block) {
  beginResetModel();
  m_rows.clear();
  for (int row = 0; row < block.size(); ++row)
    for (int column = 0; column < block[row].size(); ++column) put(row, column, block[row][column]);
  tidy();
  endResetModel();
  emit edited();
}

int CheckRowsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int CheckRowsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant CheckRowsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const QString& text = m_rows[static_cast<std::size_t>(index.row())][index.column()];
  if (role == Qt::DisplayRole) return visibleLine(text);
  if (role == Qt::EditRole) return text;
  if (role == Qt::TextAlignmentRole && index.column() >= firstAngle)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant CheckRowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
  const QString titles[columns] = {tr("Station"),    tr("Round"),    tr("Target"),      tr("Face"),
                                   tr("Horizontal"), tr("Vertical"), tr("Distance (m)")};
  const QString tips[columns] = {tr("Empty: only one station"),
                                 tr("Empty: determined from the repeated targets"),
                                 tr("Any name, the same in both faces and all rounds"),
                                 tr("Empty: determined from the vertical circle"),
                                 tr("341°52′24″, 341 52 24, 379.859gon, or plain numbers in the chosen unit"),
                                 tr("Zenith angle, in the same formats as the horizontal reading"),
                                 tr("Slope distance; may be empty")};
  if (role == Qt::DisplayRole) return titles[section];
  return role == Qt::ToolTipRole ? QVariant(tips[section]) : QVariant();
}

Qt::ItemFlags CheckRowsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

bool CheckRowsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || role != Qt::EditRole || data(index, Qt::EditRole) == value) return false;
  put(index.row(), index.column(), value.toString());
  emit dataChanged(index, index);
  if (index.row() + 1 == rowCount() && !isBlankRow(m_rows.back())) {
    beginInsertRows({}, rowCount(), rowCount());
    m_rows.push_back(blankRow());
    endInsertRows();
  }
  emit edited();
  return true;
}

}  // namespace alidade::ui
