#include "ui/models/readings_model.h"

#include <algorithm>
#include <utility>

#include "ui/commands/edit_readings.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestCell = 300;  // characters: more than any column shows

bool isRequired(ReadingColumn column) {
  return column == ReadingColumn::Horizontal || column == ReadingColumn::Vertical;
}

bool isAngle(ReadingColumn column) {
  return isRequired(column) || column == ReadingColumn::Slider;
}

bool haveSameResidual(const std::optional<SightingResidual>& a, const std::optional<SightingResidual>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->horizontal == b->horizontal && a->vertical == b->vertical));
}

}  // namespace

ReadingsModel::ReadingsModel(SessionDocument& document, std::size_t position, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_position(position) {
  m_notes.resize(readings().size());
  connect(&document, &SessionDocument::aboutToChange, this, &ReadingsModel::beginChange);
  connect(&document, &SessionDocument::changed, this, &ReadingsModel::endChange);
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
    return QVariant((column == ReadingColumn::Note ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (row >= readingCount()) return pendingRowData(column, role);
  switch (role) {
    case Qt::DisplayRole:
      return cellText(row, column);
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
    default:
      return {};
  }
}

QVariant ReadingsModel::pendingRowData(ReadingColumn column, int role) const {
  if (role == PendingRowRole) return true;
  if (role == Qt::DisplayRole && column == ReadingColumn::Point) {
    return shortLine(ReadingsEditor::following(readings()).point, longestCell);
  }
  if (role == Qt::ToolTipRole) return tr("Type here to add a reading");
  return {};
}

QString ReadingsModel::cellText(int row, ReadingColumn column) const {
  if (column == ReadingColumn::Used) return {};
  if (!readingText(column)) {
    const auto& residual = m_notes[static_cast<std::size_t>(row)].residual;
    if (!residual) return {};
    const bool horizontal = column == ReadingColumn::HorizontalResidual;
    return numberText((horizontal ? residual->horizontal : residual->vertical).arcseconds(), 1);
  }
  const std::string& typed = reading(row).*readingText(column);
  return isAngle(column) ? shortLine(shownAngle(typed), longestCell) : shortLine(typed, longestCell);
}

QString ReadingsModel::problem(int row, ReadingColumn column) const {
  if (!readingText(column)) return {};
  const std::string& typed = reading(row).*readingText(column);
  if (typed.empty()) return {};
  const auto own = entryProblem(m_document.session(), "readings." + readingFieldName(column), typed);
  if (own) return qText(*own);
  const auto& problems = m_notes[static_cast<std::size_t>(row)].problems;
  const auto found = problems.find(column);
  return found == problems.end() ? QString() : found->second;
}

QString ReadingsModel::suspicion(int row, ReadingColumn column) const {
  const auto& suspicions = m_notes[static_cast<std::size_t>(row)].suspicions;
  const auto found = suspicions.find(column);
  return found == suspicions.end() ? QString() : found->second;
}

bool ReadingsModel::isIncomplete(int row, ReadingColumn column) const {
  return isRequired(column) && (reading(row).*readingText(column)).empty();
}

QString ReadingsModel::toolTip(int row, ReadingColumn column) const {
  const QString trouble = problem(row, column);
  if (!trouble.isEmpty()) return trouble;
  if (isIncomplete(row, column)) return tr("Still to be read; until then the row is no part of the fit");
  const QString doubt = suspicion(row, column);
  if (!doubt.isEmpty()) return tr("Looks misread: %1").arg(doubt);
  if (reading(row).excluded) return tr("Excluded: kept, but no part of the fit");
  if (!readingText(column)) return {};
  const QString typed = qText(reading(row).*readingText(column));
  return isAngle(column) ? tr("As typed: %1").arg(tipText(typed)) : tipText(typed);
}

QVariant ReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    if (role != Qt::DisplayRole) return {};
    return section < readingCount() ? QString::number(section + 1) : QStringLiteral("+");
  }
  const auto column = static_cast<ReadingColumn>(section);
  if (role == Qt::DisplayRole) return columnTitle(column);
  if (role == Qt::ToolTipRole) return columnToolTip(column);
  return {};
}

QString ReadingsModel::columnTitle(ReadingColumn column) const {
  const bool elevation = m_document.session().geometry.verticalCircle == "elevation";
  const QString titles[] = {tr("Use"),          tr("Point"),
                            tr("Round"),        tr("Face"),
                            tr("Horizontal α"), elevation ? tr("Elevation β") : tr("Zenith β"),
                            tr("Slider s"),     tr("vα ″"),
                            tr("vβ ″"),         tr("Note")};
  return titles[static_cast<int>(column)];
}

QString ReadingsModel::columnToolTip(ReadingColumn column) const {
  const QString tips[] = {
      tr("Rows without a tick are kept, but are no part of the fit"),
      tr("Number of the slider's place"),
      tr("Round of readings; empty means 1"),
      tr("Face of the theodolite, 1 or 2; empty means 1"),
      tr("Reading of the horizontal circle, degrees minutes seconds; 3415224 is 341°52′24″"),
      tr("Reading of the vertical circle, degrees minutes seconds"),
      tr("Slider coordinate where it was read, degrees minutes seconds"),
      tr("Residual of the horizontal reading in arcseconds: observed − adjusted, right positive"),
      tr("Residual of the vertical reading in arcseconds: observed − adjusted, up positive"),
      tr("Free text"),
  };
  return tips[static_cast<int>(column)];
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
    editor.setExcluded({row}, value.toInt() == Qt::Unchecked);
    return true;
  }
  if (role != Qt::EditRole || !readingText(column)) return false;
  editor.setCell({row, column}, value.toString().trimmed().toStdString());
  return true;
}

void ReadingsModel::setEvaluation(const Evaluation& evaluation) {
  const std::vector<RowNotes> before = std::exchange(m_notes, std::vector<RowNotes>(readings().size()));
  if (const ArcFit* arc = evaluation.fit.arcOfPosition(m_position)) {
    for (const SightingResidual& residual : arc->residuals) {
      if (residual.row < m_notes.size()) m_notes[residual.row].residual = residual;
    }
  }
  for (const Problem& problem : evaluation.examined.problems) {
    const Place& where = problem.where;
    if (where.position != m_position || !where.reading || *where.reading >= m_notes.size()) continue;
    m_notes[*where.reading].problems.emplace(readingColumn(where.field), qText(problem.what));
  }
  for (const Suspect& suspect : evaluation.suspects) {
    const Place& where = suspect.where;
    if (where.position != m_position || !where.reading || *where.reading >= m_notes.size()) continue;
    m_notes[*where.reading].suspicions.emplace(readingColumn(where.field), qText(suspect.sentence));
  }
  tellOfNews(before);
}

/// Cells that say the same as before are not painted again.
void ReadingsModel::tellOfNews(const std::vector<RowNotes>& before) {
  const auto differ = [&](auto same) {
    return !std::equal(before.begin(), before.end(), m_notes.begin(), m_notes.end(), same);
  };
  const auto at = [this](ReadingColumn column, int row) { return index(row, static_cast<int>(column)); };
  if (differ([](const RowNotes& a, const RowNotes& b) {
        return a.problems == b.problems && a.suspicions == b.suspicions;
      }))
    emit dataChanged(index(0, 0), index(rowCount() - 1, readingColumnCount - 1));
  else if (differ(
               [](const RowNotes& a, const RowNotes& b) { return haveSameResidual(a.residual, b.residual); }))
    emit dataChanged(at(ReadingColumn::HorizontalResidual, 0),
                     at(ReadingColumn::VerticalResidual, rowCount() - 1));
}

bool ReadingsModel::isUsed(ReadingColumn column) const {
  const auto text = readingText(column);
  const std::string usual = column == ReadingColumn::Round || column == ReadingColumn::Face ? "1" : "";
  return text && std::any_of(readings().begin(), readings().end(), [&](const Reading& reading) {
           return !(reading.*text).empty() && reading.*text != usual;
         });
}

bool ReadingsModel::isMine(const SessionChange& change) const {
  return change.kind == SessionChange::Kind::Readings && change.place.position == m_position;
}

/// Rows typed after the last reading take the place of the empty row, which moves down below them: so the
/// cell that is being edited stays where it is.
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
  const auto first = static_cast<std::ptrdiff_t>(*change.place.reading);
  if (change.removed == change.inserted) {
    for (std::size_t i = 0; i < change.inserted; ++i) {
      m_notes[*change.place.reading + i].problems.clear();
      m_notes[*change.place.reading + i].suspicions.clear();
    }
  } else {
    const auto from = m_notes.erase(m_notes.begin() + first,
                                    m_notes.begin() + first + static_cast<std::ptrdiff_t>(change.removed));
    m_notes.insert(from, change.inserted, RowNotes{});
    change.removed > change.inserted ? endRemoveRows() : endInsertRows();
  }
  emit dataChanged(
      index(static_cast<int>(first), 0),
      index(std::min(static_cast<int>(first) + static_cast<int>(change.inserted), readingCount()),
            readingColumnCount - 1));
}

}  // namespace alidade::ui
