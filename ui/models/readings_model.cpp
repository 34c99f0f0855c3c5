#include "ui/models/readings_model.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/angle_text.h"
#include "core/session/entry.h"
#include "core/session/sighting_order.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/text/accessible_place.h"
#include "ui/text/entry_text.h"
#include "ui/text/journal_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestCell = 300;  // characters: more than any column shows

bool isRequired(ReadingColumn column) {
  const RowField* field = infoOf(column).field;
  return field && field->remedy;
}

QString translated(const char* text) {
  return QCoreApplication::translate("ReadingColumn", text);
}

}  // namespace

ReadingsModel::ReadingsModel(SessionDocument& document, std::size_t position, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_position(position), m_notes(position) {
  connect(&document, &SessionDocument::aboutToChange, this, &ReadingsModel::beginChange);
  connect(&document, &SessionDocument::changed, this, &ReadingsModel::endChange);
  connect(&document, &SessionDocument::chosenSightingChanged, this, [this] {
    emit dataChanged(index(readingCount(), 0), index(readingCount(), readingColumnCount - 1));
  });
  followAngles(document.session());
}

const std::vector<Reading>& ReadingsModel::readings() const {
  return m_document.session().positions.at(m_position).readings;
}

int ReadingsModel::readingCount() const {
  return static_cast<int>(readings().size());
}

int ReadingsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : readingCount() + 1;
}

int ReadingsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : readingColumnCount;
}

QVariant ReadingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto column = static_cast<ReadingColumn>(index.column());
  const int row = index.row();
  if (role == Qt::TextAlignmentRole) {
    return QVariant((isFreeText(column) ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (row >= readingCount()) return pendingRowData(column, role);
  switch (role) {
    case Qt::DisplayRole:
      return cellText(row, column);
    case Qt::AccessibleTextRole:
      return accessibleText(row, column);
    case Qt::EditRole:
      return readingText(column) ? qText(reading(row).*readingText(column)) : QVariant();
    case Qt::CheckStateRole:
      if (column != ReadingColumn::Used) return {};
      return reading(row).excluded ? Qt::Unchecked : Qt::Checked;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return toolTip(row, column);
    case ProblemRole:
      return problem(row, column);
    case SuspectRole:
      return suspicion(row, column);
    case IncompleteRole:
      return isIncomplete(row, column);
    case ExcludedRole:
      return reading(row).excluded;
    case ChangedRole:
      return infoOf(column).field && reading(row).asRead.of(infoOf(column).field->key).has_value();
    default:
      return {};
  }
}

/// The text of a cell for a screen reader, also for the check box of `Used`.
QString ReadingsModel::accessibleText(int row, ReadingColumn column) const {
  if (column == ReadingColumn::Used) return reading(row).excluded ? tr("excluded") : tr("used");
  return accessibleCell(cellText(row, column), titleOf(column));
}

QString ReadingsModel::titleOf(ReadingColumn column) const {
  return headerData(static_cast<int>(column), Qt::Horizontal, Qt::DisplayRole).toString();
}

Reading ReadingsModel::added() const {
  return followingReading(m_document.session(), m_position, m_document.chosenSighting());
}

QVariant ReadingsModel::pendingRowData(ReadingColumn column, int role) const {
  if (role == PendingRowRole) return true;
  if (role == Qt::AccessibleTextRole && column != ReadingColumn::Point)
    return tr("%1: to be added").arg(titleOf(column));
  if (role == Qt::DisplayRole && column == ReadingColumn::Point) {
    return shortLine(added().point, longestCell);
  }
  if (role == Qt::ToolTipRole) return tr("Type here to add a reading");
  return {};
}

QString ReadingsModel::cellText(int row, ReadingColumn column) const {
  if (column == ReadingColumn::Used) return {};
  if (!readingText(column)) {
    const SightingResidual* residual = m_notes.residual(static_cast<std::size_t>(row));
    if (!residual) return {};
    const bool horizontal = column == ReadingColumn::HorizontalResidual;
    return numberText((horizontal ? residual->horizontal : residual->vertical).arcseconds(), 1);
  }
  const std::string& typed = reading(row).*readingText(column);
  return shortLine(isAngle(column) ? shownAngle(typed, m_unit, decimalsIn(column)) : qText(typed),
                   longestCell);
}

QString ReadingsModel::problem(int row, ReadingColumn column) const {
  if (!readingText(column)) return {};
  const std::string& typed = reading(row).*readingText(column);
  if (typed.empty()) return {};
  const std::string name = "readings." + std::string(infoOf(column).field->key);
  const auto own = entryProblem(m_document.session(), name, typed);
  return own ? qText(*own) : m_notes.problem(static_cast<std::size_t>(row), column);
}

QString ReadingsModel::suspicion(int row, ReadingColumn column) const {
  const QString suspicion = m_notes.suspicion(static_cast<std::size_t>(row), column);
  if (!suspicion.isEmpty()) return tr("Looks misread: %1").arg(suspicion);
  const auto doubt = m_doubts.find({static_cast<std::size_t>(row), column});
  return doubt != m_doubts.end() && doubt->second.of == reading(row).*readingText(column) ? doubt->second.text
                                                                                          : QString();
}

void ReadingsModel::setDoubt(std::size_t row, ReadingColumn column, const QString& doubt) {
  if (row >= readings().size()) return;
  if (doubt.isEmpty())
    m_doubts.erase({row, column});
  else
    m_doubts[{row, column}] = {readings()[row].*readingText(column), doubt};
  const QModelIndex cell = index(static_cast<int>(row), static_cast<int>(column));
  emit dataChanged(cell, cell);
}

bool ReadingsModel::isIncomplete(int row, ReadingColumn column) const {
  return isRequired(column) && (reading(row).*readingText(column)).empty();
}

ReadingsModel::OpenCell ReadingsModel::firstOpenCell() const {
  const auto row = std::ranges::find_if(readings(), [](const Reading& reading) {
    return !reading.excluded && (reading.horizontal.empty() || reading.vertical.empty());
  });
  const bool isHalf = row != readings().end() && !row->horizontal.empty();
  return {static_cast<int>(row - readings().begin()),
          isHalf ? ReadingColumn::Vertical : ReadingColumn::Horizontal};
}

QString ReadingsModel::changeTip(int row, ReadingColumn column) const {
  const RowField* field = infoOf(column).field;
  const auto first = field ? reading(row).asRead.of(field->key) : std::nullopt;
  if (!first) return {};
  const QString text = tr("First entered as %1").arg(tipText(qText(*first)));
  const Session& session = m_document.session();
  const JournalEntry* entry = lastChange(session, m_position, static_cast<std::size_t>(row), *field);
  return entry ? text + QStringLiteral("; ") + changeText(*entry, m_document.session()) : text;
}

QString ReadingsModel::toolTip(int row, ReadingColumn column) const {
  const QString change = changeTip(row, column);
  const QString other = otherTip(row, column);
  return change.isEmpty() || other.isEmpty() ? change + other : other + QStringLiteral("\n") + change;
}

QString ReadingsModel::otherTip(int row, ReadingColumn column) const {
  const QString trouble = problem(row, column);
  if (!trouble.isEmpty()) return trouble;
  if (isIncomplete(row, column)) return tr("Still to be read; until then the row is not used in the fit");
  const QString doubt = suspicion(row, column);
  if (!doubt.isEmpty()) return doubt;
  if (reading(row).excluded) return tr("Excluded: kept, but not used in the fit");
  if (!readingText(column)) return residualTip(row, column);
  const QString typed = qText(reading(row).*readingText(column));
  return isAngle(column) ? tr("As typed: %1").arg(tipText(typed)) : tipText(typed);
}

QString ReadingsModel::residualTip(int row, ReadingColumn column) const {
  const SightingResidual* residual = m_notes.residual(static_cast<std::size_t>(row));
  if (!residual) return {};
  const double standardised = column == ReadingColumn::HorizontalResidual ? residual->horizontalStandardised
                                                                          : residual->verticalStandardised;
  if (std::isnan(standardised))
    return tr("No other reading checks this one: its residual cannot show an error");
  return tr("Standardised residual w = v/(s0 σ √r): %1").arg(signedNumberText(standardised, 2));
}

QVariant ReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    if (role != Qt::DisplayRole) return {};
    return section < readingCount() ? QString::number(section + 1) : QStringLiteral("+");
  }
  const auto column = static_cast<ReadingColumn>(section);
  if (role == Qt::DisplayRole) return columnTitle(column);
  if (role == Qt::ToolTipRole) return translated(infoOf(column).toolTip);
  return {};
}

QString ReadingsModel::columnTitle(ReadingColumn column) const {
  const bool elevation = m_document.session().geometry.verticalCircle == "elevation";
  return column == ReadingColumn::Vertical && elevation ? tr("Elevation β")
                                                        : translated(infoOf(column).title);
}

Qt::ItemFlags ReadingsModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const auto column = static_cast<ReadingColumn>(index.column());
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  if (column == ReadingColumn::Used) {
    return index.row() < readingCount() ? flags | Qt::ItemIsUserCheckable : flags;
  }
  return readingText(column) ? flags | Qt::ItemIsEditable : flags;
}

bool ReadingsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto column = static_cast<ReadingColumn>(index.column());
  const auto row = static_cast<std::size_t>(index.row());
  ReadingsEditor editor(m_document, m_position);
  if (column == ReadingColumn::Used && role == Qt::CheckStateRole) {
    const bool excludes = value.toInt() == Qt::Unchecked;
    editor.setExcluded({row}, excludes);
    if (excludes) emit excludedByClick(row);
    return true;
  }
  if (role != Qt::EditRole || !readingText(column)) return false;
  editor.setCell({row, column}, value.toString().trimmed().toStdString());
  return true;
}

int ReadingsModel::decimalsIn(ReadingColumn column) const {
  const auto found = m_decimals.find(column);
  return found == m_decimals.end() ? 0 : found->second;
}

/// Sets the unit of shown angles, and the decimals of each column to those of the finest angle in its first
/// thousand rows. Returns true if the unit or a number of decimals changed.
bool ReadingsModel::followAngles(const Session& session) {
  constexpr std::size_t most = 1000;
  if (m_position >= session.positions.size()) return false;
  const auto& rows = session.positions[m_position].readings;
  const auto before = std::pair(m_unit, m_decimals);
  m_unit = circleUnitOf(session);
  m_decimals.clear();
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    if (!isAngle(info.column)) continue;
    int finest = 0;
    for (std::size_t row = 0; row < std::min(rows.size(), most); ++row)
      if (const Result<Angle> angle = parseAngle(rows[row].*readingText(info.column)))
        finest = std::max(finest, decimalsOf(*angle, m_unit));
    if (finest > 0) m_decimals[info.column] = finest;
  }
  return before != std::pair(m_unit, m_decimals);
}

/// Signals only the residuals if nothing else changed, and nothing if all texts stay the same.
void ReadingsModel::setEvaluation(SharedEvaluation evaluation) {
  const bool isShownAlike = !followAngles(evaluation->session);
  const RowNotes::News news = std::max(m_notes.setEvaluation(std::move(evaluation)),
                                       isShownAlike ? RowNotes::News::None : RowNotes::News::Everything);
  const auto at = [this](ReadingColumn column, int row) { return index(row, static_cast<int>(column)); };
  if (news == RowNotes::News::Everything)
    emit dataChanged(index(0, 0), index(rowCount() - 1, readingColumnCount - 1));
  else if (news == RowNotes::News::Residuals)
    emit dataChanged(at(ReadingColumn::HorizontalResidual, 0),
                     at(ReadingColumn::VerticalResidual, rowCount() - 1));
}

bool ReadingsModel::isUsed(ReadingColumn column) const {
  return isUsed(column, 0, readings().size());
}

bool ReadingsModel::isUsed(ReadingColumn column, std::size_t first, std::size_t count) const {
  const auto text = readingText(column);
  if (!text) return false;
  const std::string usual = usualText(*infoOf(column).field);
  const auto from = std::next(readings().begin(), static_cast<std::ptrdiff_t>(first));
  return std::any_of(from, std::next(from, static_cast<std::ptrdiff_t>(count)),
                     [&](const Reading& row) { return !(row.*text).empty() && row.*text != usual; });
}

QString ReadingsModel::copiedText(int row, ReadingColumn column) const {
  return isEntered(column) ? qText(enteredText(reading(row), column)) : cellText(row, column);
}

bool ReadingsModel::isMine(const SessionChange& change) const {
  return change.kind == SessionChange::Kind::Readings && change.place.position == m_position;
}

/// Rows typed after the last reading take the place of the empty row, which moves down, so that the cell
/// being edited keeps its index.
void ReadingsModel::beginChange(const SessionChange& change) {
  if (!isMine(change) || change.removed == change.inserted) return;
  const int first = static_cast<int>(*change.place.reading);
  const int removed = static_cast<int>(change.removed), inserted = static_cast<int>(change.inserted);
  const int at = first + std::min(removed, inserted);
  if (removed > inserted) {
    beginRemoveRows({}, at, first + removed - 1);
  } else {
    const int below = first + removed == readingCount() ? 1 : 0;
    beginInsertRows({}, at + below, first + inserted - 1 + below);
  }
}

void ReadingsModel::endChange(const SessionChange& change) {
  if (change.kind == SessionChange::Kind::Field) {
    emit headerDataChanged(Qt::Horizontal, 0, readingColumnCount - 1);
    return;
  }
  if (!isMine(change)) return;
  const std::size_t first = *change.place.reading;
  m_notes.replaceRows(first, change.removed, change.inserted);
  if (change.removed != change.inserted)
    m_doubts.erase(m_doubts.lower_bound({first, ReadingColumn::Used}), m_doubts.end());
  if (change.removed > change.inserted) endRemoveRows();
  if (change.removed < change.inserted) endInsertRows();
  emit dataChanged(
      index(static_cast<int>(first), 0),
      index(std::min(static_cast<int>(first) + static_cast<int>(change.inserted), readingCount()),
            readingColumnCount - 1));
}

}  // namespace alidade::ui
