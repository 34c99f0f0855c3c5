#include "ui/import/import_preview.h"

#include <QApplication>
#include <QPalette>
#include <algorithm>
#include <iterator>
#include <utility>

#include "core/session/entry.h"
#include "core/session/row_fields.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// The field shown in a column; null if none.
const RowField* fieldOf(ImportPreview::Column column) {
  switch (column) {
    case ImportPreview::Column::Point:
      return &rowField(&Reading::point);
    case ImportPreview::Column::Round:
      return &rowField(&Reading::round);
    case ImportPreview::Column::Face:
      return &rowField(&Reading::face);
    case ImportPreview::Column::Horizontal:
      return &rowField(&Reading::horizontal);
    case ImportPreview::Column::Vertical:
      return &rowField(&Reading::vertical);
    case ImportPreview::Column::Slider:
      return &rowField(&Reading::slider);
    case ImportPreview::Column::TiltCross:
      return &rowField(&Reading::tiltCrossArcsec);
    case ImportPreview::Column::TiltLength:
      return &rowField(&Reading::tiltLengthArcsec);
    case ImportPreview::Column::Corrections:
      return &rowField(&Reading::corrections);
    case ImportPreview::Column::Note:
      return &rowField(&Reading::note);
    default:
      return nullptr;
  }
}

/// The line of the file from which the row at `offset` of an origin was read.
std::size_t lineOf(const ImportedRows& origin, std::size_t offset) {
  for (const auto& [first, last] : origin.lines) {
    const std::size_t count = last - first + 1;
    if (offset < count) return first + offset;
    offset -= count;
  }
  return 0;
}

}  // namespace

void ImportPreview::setReading(std::shared_ptr<const ImportReading> reading) {
  beginResetModel();
  m_reading = std::move(reading);
  m_begins.clear();
  if (m_reading && m_reading->import) {
    std::size_t begin = 0;
    for (const ImportedRows& origin : m_reading->import->origins) {
      m_begins.push_back(begin);
      begin += origin.count;
    }
    const auto circle = verticalCircleEntry(m_reading->import->session.geometry.verticalCircle);
    m_circle = circle ? *circle : VerticalCircle::Zenith;
    m_unit = circleUnitOf(m_reading->import->session);
  }
  endResetModel();
}

bool ImportPreview::isShown(Column column) const {
  if (!m_reading) return true;
  switch (column) {
    case Column::Round:
      return m_reading->hasRounds;
    case Column::Face:
      return m_reading->hasFaces;
    case Column::Slider:
      return m_reading->hasSliders;
    case Column::TiltCross:
    case Column::TiltLength:
      return m_reading->hasTilts;
    case Column::Corrections:
      return m_reading->hasCorrections;
    case Column::Note:
      return m_reading->hasNotes;
    default:
      return true;
  }
}

int ImportPreview::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || m_begins.empty() ? 0 : static_cast<int>(m_reading->import->rows);
}

int ImportPreview::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

ImportPreview::Row ImportPreview::rowAt(int row) const {
  const auto wanted = static_cast<std::size_t>(row);
  const auto found = std::prev(std::upper_bound(m_begins.begin(), m_begins.end(), wanted));
  const Import& import = *m_reading->import;
  const ImportedRows& origin = import.origins[static_cast<std::size_t>(found - m_begins.begin())];
  const std::size_t offset = wanted - *found;
  return {&origin, offset, &import.session.positions[origin.position].readings[origin.firstRow + offset]};
}

QString ImportPreview::text(const Row& row, Column column) const {
  const std::vector<std::size_t>& unplaced = m_reading->import->unplaced;
  if (column == Column::Position)
    return std::ranges::find(unplaced, row.origin->file) == unplaced.end()
               ? positionText(m_reading->import->session, row.origin->position)
               : tr("?");
  if (column == Column::Origin) return QString::number(lineOf(*row.origin, row.offset));
  if (column == Column::Used) return row.reading->excluded ? tr("no") : tr("yes");
  const RowField& field = *fieldOf(column);
  const std::string& typed = row.reading->*field.text;
  return isAngle(field) ? visibleLine(shownAngle(typed, m_unit)) : shortLine(typed, 200);
}

QString ImportPreview::problem(const Row& row, Column column) const {
  const RowField* field = fieldOf(column);
  if (!field || row.reading->excluded) return {};
  const auto problem = entryProblem(*field, row.reading->*field->text, m_circle);
  return problem ? visibleLine(problem->what) : QString();
}

QVariant ImportPreview::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto column = static_cast<Column>(index.column());
  const Row row = rowAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(row, column);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return problem(row, column);
    case Qt::ForegroundRole:
      if (!problem(row, column).isEmpty()) return stateColor(QApplication::palette(), State::Bad);
      return row.reading->excluded
                 ? QVariant(QApplication::palette().color(QPalette::Disabled, QPalette::Text))
                 : QVariant();
    case Qt::BackgroundRole:
      return problem(row, column).isEmpty() ? QVariant() : stateTint(QApplication::palette(), State::Bad);
    case Qt::TextAlignmentRole:
      return column == Column::Note ? QVariant(Qt::AlignVCenter | Qt::AlignLeft)
                                    : QVariant(Qt::AlignVCenter | Qt::AlignRight);
    default:
      return {};
  }
}

QVariant ImportPreview::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section + 1;
  switch (static_cast<Column>(section)) {
    case Column::Position:
      return tr("Position");
    case Column::Origin:
      return tr("Line");
    case Column::Used:
      return tr("Used");
    case Column::Point:
      return tr("Point");
    case Column::Round:
      return tr("Round");
    case Column::Face:
      return tr("Face");
    case Column::Horizontal:
      return tr("Horizontal α");
    case Column::Vertical:
      return m_circle == VerticalCircle::Zenith ? tr("Zenith β") : tr("Elevation β");
    case Column::Slider:
      return tr("Slider s");
    case Column::TiltCross:
      return tr("Tilt ⟂ ″");
    case Column::TiltLength:
      return tr("Tilt ∥ ″");
    case Column::Corrections:
      return tr("Corrections");
    case Column::Note:
      return tr("Note");
  }
  return {};
}

}  // namespace alidade::ui
