#include "ui/models/known_sizes_model.h"

#include <algorithm>
#include <utility>

#include "core/base/phrase.h"
#include "core/session/measurement.h"
#include "core/wording/findings.h"
#include "ui/commands/change_session.h"
#include "ui/document/session_document.h"
#include "ui/text/accessible_place.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/known_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

using Column = KnownSizesModel::Column;

constexpr int longestText = 300;  // characters: more than any column shows
constexpr int columnsOfKnown = static_cast<int>(Column::From) + 1;

/// The text of a known size that the column edits; null if the column is not editable.
const KnownCell* typedInto(Column column) {
  if (column < Column::Value) return nullptr;
  return &knownCells[static_cast<int>(column) - static_cast<int>(Column::Value)];
}

Column columnOf(const std::string& member) {
  for (const Column column : {Column::Value, Column::Sigma, Column::From})
    if (member == typedInto(column)->member) return column;
  return Column::Value;
}

QString unitOf(const KnownRow& row) {
  return row.parameter ? unitText(std::string(row.parameter->unit)) : QString();
}

QString ownerName(KnownOwner owner) {
  return owner == KnownOwner::Device ? KnownSizesModel::tr("device") : KnownSizesModel::tr("instrument");
}

/// The owner from the session if stated, else from the catalogue.
KnownOwner shownOwner(const KnownRow& row) {
  return row.entry ? row.entry->owner : ownerOf(*row.effect);
}

QString titleOf(Column column) {
  switch (column) {
    case Column::Number:
      return KnownSizesModel::tr("Effect");
    case Column::Owner:
      return KnownSizesModel::tr("Belongs to");
    case Column::Default:
      return KnownSizesModel::tr("Default u");
    case Column::Value:
      return KnownSizesModel::tr("Value");
    case Column::Sigma:
      return KnownSizesModel::tr("u");
    case Column::From:
      break;
  }
  return KnownSizesModel::tr("Known from");
}

Qt::Alignment alignmentOf(Column column) {
  const bool isFigure = column >= Column::Default && column <= Column::Sigma;
  return (isFigure ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter;
}

QString inWords(const KnownSize& unknown) {
  const Words words =
      wordsOf(session_finding::KnownOfNothing{unknown.effect, unknown.parameter, unknown.unit});
  return qText(words.text + " " + words.remedy);
}

}  // namespace

KnownSizesModel::KnownSizesModel(SessionDocument& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_rows(knownRows(document.session())) {
  connect(&document, &SessionDocument::changed, this, &KnownSizesModel::follow);
}

int KnownSizesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int KnownSizesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columnsOfKnown;
}

QVariant KnownSizesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto column = static_cast<Column>(index.column());
  const KnownRow& row = this->row(index);
  const KnownCell* cell = typedInto(column);
  switch (role) {
    case Qt::DisplayRole:
      return text(index);
    case Qt::AccessibleTextRole:
      return accessibleCell(text(index),
                            headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString());
    case Qt::EditRole:
      return cell ? QVariant(qText(typed(row, *cell))) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant(alignmentOf(column));
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return about(index);
    case ProblemRole:
      return problem(row, column);
    case IncompleteRole:
      return column == Column::Sigma && row.entry && typed(row, *cell).empty();
    case QuietRole:
      return !cell ? column != Column::Number : typed(row, *cell).empty();
    default:
      return {};
  }
}

QVariant KnownSizesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) return {};
  const auto column = static_cast<Column>(section);
  const QString tips[columnsOfKnown] = {
      tr("Catalogued effect, or one of its quantities"),
      tr("Device or instrument to which the known size belongs"),
      tr("Plausible size (1σ), used if no size is known"),
      tr("Known size, in the unit of the default; empty: 0"),
      tr("Standard uncertainty of the known size, in the unit of the default; empty: the default"),
      tr("Certificate or check that gives the known size; named in the budget")};
  if (role == Qt::DisplayRole) return titleOf(column);
  if (role == Qt::TextAlignmentRole) return QVariant(alignmentOf(column));
  return role == Qt::ToolTipRole ? tips[section] : QVariant();
}

Qt::ItemFlags KnownSizesModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return typedInto(static_cast<Column>(index.column())) ? flags | Qt::ItemIsEditable : flags;
}

bool KnownSizesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const KnownCell* cell = typedInto(static_cast<Column>(index.column()));
  if (role != Qt::EditRole || !cell) return false;
  typeKnown(m_document, KnownRow(row(index)), *cell, value.toString().trimmed().toStdString());
  return true;
}

bool KnownSizesModel::hasProblem() const {
  return std::ranges::any_of(m_rows, [this](const KnownRow& row) {
    return !problem(row, Column::Value).isEmpty() || !problem(row, Column::Sigma).isEmpty();
  });
}

QModelIndex KnownSizesModel::cellOf(const KnownPlace& place) const {
  const auto found = std::ranges::find(m_rows, place.ref, &KnownRow::entry);
  const int row = found == m_rows.end() ? m_lastChanged : static_cast<int>(found - m_rows.begin());
  return row < 0 ? QModelIndex() : index(row, static_cast<int>(columnOf(place.member)));
}

QModelIndex KnownSizesModel::cellOf(const std::string& effect) const {
  const auto found = std::ranges::find_if(
      m_rows, [&](const KnownRow& row) { return row.effect && row.effect->id == effect; });
  if (found == m_rows.end()) return {};
  return index(static_cast<int>(found - m_rows.begin()), static_cast<int>(Column::Value));
}

HalfTypedText KnownSizesModel::halfTyped(const QModelIndex& cell, const QString& text) const {
  const KnownRow& row = this->row(cell);
  const char* member = typedInto(static_cast<Column>(cell.column()))->member;
  if (row.entry) return {.place = placeOf(*row.entry, member), .text = text.toStdString()};
  return {.place = {.field = member},
          .effect = std::string(row.effect->id),
          .parameter = std::string(row.parameter->name),
          .text = text.toStdString()};
}

const std::string& KnownSizesModel::typed(const KnownRow& row, const KnownCell& cell) const {
  static const std::string nothing;
  const KnownSize* size = row.entry ? knownSize(m_document.session(), *row.entry) : nullptr;
  return size ? size->*cell.text : nothing;
}

QString KnownSizesModel::text(const QModelIndex& index) const {
  return cellText(row(index), static_cast<Column>(index.column()));
}

QString KnownSizesModel::cellText(const KnownRow& row, Column column) const {
  switch (column) {
    case Column::Number: {
      const QString known = knownName(m_document.session(), row),
                    name = row.effect ? capitalised(known) : known;
      return row.isFurther ? tr("%1 (again)").arg(name) : name;
    }
    case Column::Owner:
      return ownerName(shownOwner(row));
    case Column::Default:
      return row.parameter ? plausibleText(*row.parameter) : QString();
    case Column::Value:
    case Column::Sigma: {
      const QString shown = shortLine(typed(row, *typedInto(column)), longestText);
      return shown.isEmpty() || !problem(row, column).isEmpty() ? shown : withUnit(shown, unitOf(row));
    }
    case Column::From:
      break;
  }
  return row.entry ? shortLine(typed(row, *typedInto(column)), longestText) : tr("default");
}

QString KnownSizesModel::problem(const KnownRow& row, Column column) const {
  if (column == Column::Number && row.entry && !row.effect)
    return inWords(*knownSize(m_document.session(), *row.entry));
  const KnownCell* cell = typedInto(column);
  if (!cell || typed(row, *cell).empty()) return {};
  const std::string field = std::string("instrument.known.") + cell->member;
  return qText(entryProblem(m_document.session(), field, typed(row, *cell)).value_or(""));
}

/// The problem of the cell, or of the value or the u in its row; else an explanation of the cell or row.
QString KnownSizesModel::about(const QModelIndex& index) const {
  const KnownRow& row = this->row(index);
  const auto column = static_cast<Column>(index.column());
  const QString trouble = problem(row, column);
  if (!trouble.isEmpty()) return trouble;
  if (index.data(IncompleteRole).toBool())
    return tr("Type the standard uncertainty of the known size; until then the default is used.");
  for (const Column other : {Column::Value, Column::Sigma})
    if (const QString otherTrouble = problem(row, other); !otherTrouble.isEmpty())
      return QStringLiteral("%1: %2").arg(titleOf(other), otherTrouble);
  if (column == Column::From && !typed(row, *typedInto(column)).empty())
    return tipText(qText(typed(row, *typedInto(column))));
  if (!row.effect) return problem(row, Column::Number);
  if (row.isFurther)
    return tr(
        "The session has several known sizes for this quantity: their mean, weighted by 1/u², is used.");
  return tr("%1. Its known size belongs to the %2.")
      .arg(capitalised(qText(Phrase::of(row.effect->description))), ownerName(ownerOf(*row.effect)));
}

/// The changed row is the first row that gained or lost an entry: later entries only shift their index.
void KnownSizesModel::follow(const SessionChange& change) {
  if (change.kind != SessionChange::Kind::Everything && !knownAt(change.place)) return;
  std::vector<KnownRow> rows = knownRows(m_document.session());
  const auto changed = std::ranges::mismatch(rows, m_rows, [](const KnownRow& a, const KnownRow& b) {
                         return a.parameter == b.parameter && a.entry.has_value() == b.entry.has_value();
                       }).in1;
  m_lastChanged = changed == rows.end() ? -1 : static_cast<int>(changed - rows.begin());
  const bool isReset = rows.size() != m_rows.size();
  if (isReset) beginResetModel();
  m_rows = std::move(rows);
  if (isReset)
    endResetModel();
  else
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnsOfKnown - 1));
}

}  // namespace alidade::ui
