#include "ui/panels/readings/readings_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <algorithm>
#include <set>

#include "ui/document/session_document.h"
#include "ui/panels/readings/reading_delegate.h"
#include "ui/panels/readings/reason_line.h"
#include "ui/settings/window_font.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

bool isOptional(const ReadingColumnInfo& info) {
  return info.menuText != nullptr;
}

ReadingColumn columnOf(const QModelIndex& index) {
  return static_cast<ReadingColumn>(index.column());
}

}  // namespace

ReadingsTable::ReadingsTable(SessionDocument& document, std::size_t position, QWidget* parent)
    : EntryTable(new ReadingDelegate, parent),
      m_model(document, position),
      m_editor(document, position),
      m_reason(new ReasonLine(*this)) {
  setModel(&m_model);
  setAccessibleName(tr("Readings"));
  connect(&document, &SessionDocument::changed, this, &ReadingsTable::showColumnsUsedBy);
  connect(this, &EntryTable::typed, this,
          [this, &document](const QLineEdit* editor, const QModelIndex& cell) {
            document.halfTyped().set(editor, halfTyped(*editor, cell),
                                     editor->text() != cell.data(Qt::EditRole).toString());
          });
  connect(this, &EntryTable::typingEnded, &document.halfTyped(), &HalfTyped::clear);
  connect(
      &m_model, &ReadingsModel::excludedByClick, this, [this](std::size_t row) { askReason({row}); },
      Qt::QueuedConnection);
  reportReason(document.halfTyped());
  connect(m_reason, &ReasonLine::given, this,
          [this](const std::vector<std::size_t>& rows, const QString& reason) {
            m_editor.addReason(rows, reason.toStdString());
          });
  layOutColumns();
  showUsedColumns();
}

/// Reports a reason being typed as the notes that it would make.
void ReadingsTable::reportReason(HalfTyped& halfTyped) {
  connect(m_reason, &QLineEdit::textEdited, this, [this, &halfTyped](const QString& text) {
    const std::string reason = text.trimmed().toStdString();
    std::vector<HalfTypedText> notes;
    for (const std::size_t row : m_reason->rows())
      notes.push_back({.place = {.position = m_model.position(), .reading = row, .field = "note"},
                       .text = m_editor.noteWith(row, reason)});
    halfTyped.set(m_reason, std::move(notes), !reason.empty());
  });
  connect(m_reason, &ReasonLine::closed, &halfTyped, [this, &halfTyped] { halfTyped.clear(m_reason); });
}

void ReadingsTable::askReason(const std::vector<std::size_t>& rows) {
  m_reason->ask(rows);
}

void ReadingsTable::commitReason() {
  m_reason->finish();
}

HalfTypedText ReadingsTable::halfTyped(const QLineEdit& editor, const QModelIndex& cell) const {
  const RowField* field = infoOf(columnOf(cell)).field;
  const Reading added = cell.row() < m_model.readingCount() ? Reading() : m_model.added();
  return {.place = {.position = m_model.position(),
                    .reading = static_cast<std::size_t>(cell.row()),
                    .field = std::string(field->key)},
          .point = added.point,
          .round = added.round,
          .face = added.face,
          .text = editor.text().trimmed().toStdString()};
}

void ReadingsTable::layOutColumns() {
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultAlignment(Qt::AlignCenter);
  QHeaderView* header = horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(36);
  layOutByFont(*this, [this] { fitCells(); });
  header->setStretchLastSection(true);
  constexpr int last = readingColumnCount - 1;
  connect(header, &QHeaderView::sectionResized, this, [this](int column, int, int) {
    if (!m_isFitting && column != last) m_isFitted = false;
  });
}

void ReadingsTable::fitCells() {
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    if (!info.widest) continue;  // `fitAngles` sets the width of angle columns
    const int sparedByResiduals = info.field ? 0 : 4;
    setColumnWidth(static_cast<int>(info.column), widthOf(info.widest) - sparedByResiduals);
  }
  m_isFitted = true;
  fitAngles();
}

int ReadingsTable::widthOf(const char* sample) const {
  return fontMetrics().horizontalAdvance(QString::fromUtf8(sample)) + 12;
}

/// Gives the angle columns room for a tenth of a second and a sign, or at least for a second and a sign.
void ReadingsTable::fitAngles() {
  if (!m_isFitted) return;
  const auto width = [this](const char* sample) { return widthOf(sample) + ReadingDelegate::signWidth + 2; };
  const int least = width("341°52′24″");
  const int most = std::max(width("341°52′24.5″"), width("341°52'24.5\""));
  int room = viewport()->width() - widthOf("Note"), angles = 0;
  for (int column = 0; column < readingColumnCount - 1; ++column) {
    if (isColumnHidden(column)) continue;
    isAngle(static_cast<ReadingColumn>(column)) ? ++angles : room -= columnWidth(column);
  }
  const QScopedValueRollback fitting(m_isFitting, true);
  for (const ReadingColumnInfo& info : allReadingColumns())
    if (isAngle(info.column))
      setColumnWidth(static_cast<int>(info.column), std::clamp(room / std::max(1, angles), least, most));
}

void ReadingsTable::resizeEvent(QResizeEvent* event) {
  EntryTable::resizeEvent(event);
  fitAngles();
}

void ReadingsTable::setColumnShown(ReadingColumn column, bool shown) {
  m_wanted.erase(std::remove(m_wanted.begin(), m_wanted.end(), column), m_wanted.end());
  if (shown) m_wanted.push_back(column);
  showUsedColumns();
}

void ReadingsTable::showUsedColumns() {
  const QScopedValueRollback fitting(m_isFitting, true);
  for (const ReadingColumnInfo& info : allReadingColumns()) {
    if (!isOptional(info)) continue;
    const bool wanted = std::find(m_wanted.begin(), m_wanted.end(), info.column) != m_wanted.end();
    setColumnHidden(static_cast<int>(info.column), !wanted && !m_model.isUsed(info.column));
  }
  fitAngles();
}

/// Updates the shown columns if needed. A hidden column can come into use only by the changed rows.
void ReadingsTable::showColumnsUsedBy(const SessionChange& change) {
  if (change.kind != SessionChange::Kind::Readings || change.place.position != m_model.position()) return;
  const bool isRight = std::ranges::all_of(allReadingColumns(), [&](const ReadingColumnInfo& info) {
    if (!isOptional(info)) return true;
    if (isColumnHidden(static_cast<int>(info.column)))
      return !m_model.isUsed(info.column, *change.place.reading, change.inserted);
    return std::find(m_wanted.begin(), m_wanted.end(), info.column) != m_wanted.end() ||
           m_model.isUsed(info.column);
  });
  if (!isRight) showUsedColumns();
}

void ReadingsTable::selectCell(int row, ReadingColumn column) {
  const QModelIndex cell = m_model.index(std::min(row, m_model.readingCount()), static_cast<int>(column));
  if (isColumnHidden(cell.column())) setColumnShown(column, true);
  goTo(cell);
}

QModelIndex ReadingsTable::nextEntryCell() const {
  const ReadingsModel::OpenCell cell = m_model.firstOpenCell();
  return m_model.index(cell.row, static_cast<int>(cell.column));
}

void ReadingsTable::goToNextEntry() {
  goTo(nextEntryCell());
}

QModelIndex ReadingsTable::firstCell() const {
  const QModelIndex next = nextEntryCell();
  return next.row() < m_model.readingCount() ? next
                                             : m_model.index(0, static_cast<int>(ReadingColumn::Horizontal));
}

void ReadingsTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  EntryTable::currentChanged(current, previous);
  if (current.isValid() && current.row() != previous.row() && current.row() < m_model.readingCount()) {
    emit rowEntered(static_cast<std::size_t>(current.row()));
  }
}

bool ReadingsTable::handleEditKey(const QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier) {
    toggleExcluded();
  } else if (event->key() == Qt::Key_Minus && event->modifiers() & Qt::ControlModifier) {
    deleteSelected();
  } else if (event->key() == Qt::Key_I && event->modifiers() == Qt::ControlModifier) {
    insertAbove();
  } else {
    return EntryTable::handleEditKey(event);
  }
  return true;
}

/// The cell after a key that ends an entry. Return: from horizontal to vertical, then to the next row's
/// horizontal; in other columns, down. Tab: to the next shown column; from vertical, or from the slider if it
/// is shown, to the next row's horizontal. Invalid: out of the table.
QModelIndex ReadingsTable::onward(const QModelIndex& from, int key) const {
  if (!from.isValid()) return m_model.index(0, static_cast<int>(ReadingColumn::Horizontal));
  const auto cell = [this](int row, ReadingColumn column) {
    return m_model.index(std::min(row, m_model.readingCount()), static_cast<int>(column));
  };
  const ReadingColumn column = columnOf(from);
  const bool pending = from.row() >= m_model.readingCount();
  if (key == Qt::Key_Backtab) return neighbour(from, -1);
  if (column == ReadingColumn::Horizontal) return cell(from.row(), ReadingColumn::Vertical);
  const bool sliderNext = key == Qt::Key_Tab && !isColumnHidden(static_cast<int>(ReadingColumn::Slider));
  if (column == ReadingColumn::Vertical && !sliderNext) {
    return pending && key == Qt::Key_Tab ? QModelIndex() : cell(from.row() + 1, ReadingColumn::Horizontal);
  }
  if (column == ReadingColumn::Slider && key == Qt::Key_Tab) {
    return pending ? QModelIndex() : cell(from.row() + 1, ReadingColumn::Horizontal);
  }
  if (key == Qt::Key_Tab) return neighbour(from, 1);
  return cell(from.row() + 1, column);
}

std::vector<std::size_t> ReadingsTable::selectedRows() const {
  std::vector<std::size_t> rows;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= std::min(range.bottom(), m_model.readingCount() - 1); ++row)
      rows.push_back(static_cast<std::size_t>(row));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// The selected cells, row by row.
std::vector<ReadingCell> ReadingsTable::selectedCells() const {
  std::vector<ReadingCell> cells;
  for (const QItemSelectionRange& range : selectionModel()->selection()) {
    std::vector<ReadingColumn> shown;
    for (int column = range.left(); column <= range.right(); ++column)
      if (!isColumnHidden(column)) shown.push_back(static_cast<ReadingColumn>(column));
    cells.reserve(cells.size() + static_cast<std::size_t>(range.height()) * shown.size());
    for (int row = range.top(); row <= range.bottom(); ++row)
      for (const ReadingColumn column : shown) cells.push_back({static_cast<std::size_t>(row), column});
  }
  return cells;
}

std::vector<ReadingColumn> ReadingsTable::columnsFrom(int column) const {
  std::vector<ReadingColumn> columns;
  for (; column < readingColumnCount; ++column) {
    const auto candidate = static_cast<ReadingColumn>(column);
    if (!isColumnHidden(column) && isEntered(candidate)) columns.push_back(candidate);
  }
  return columns;
}

/// Copies the rectangle around the selection as typed; residuals only if nothing else is selected.
void ReadingsTable::copy() const {
  std::set<int> entered, computed;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int column = range.left(); column <= range.right(); ++column)
      if (!isColumnHidden(column))
        (isEntered(static_cast<ReadingColumn>(column)) ? entered : computed).insert(column);
  const std::vector<std::size_t> rows = selectedRows();
  BlockText block;
  for (const std::size_t row : rows) {
    block.beginRow();
    for (const int column : entered.empty() ? computed : entered)
      block.add(m_model.copiedText(static_cast<int>(row), static_cast<ReadingColumn>(column)));
  }
  if (!rows.empty()) copyBlock(block.text());
}

void ReadingsTable::cut() {
  copy();
  m_editor.clear(selectedCells(), true);
}

void ReadingsTable::paste() {
  const ReadingBlock block = clipboardBlock();
  if (block.isEmpty()) return;
  QModelIndex corner = currentIndex();
  for (const QItemSelectionRange& range : selectionModel()->selection())
    corner = m_model.index(std::min(corner.row(), range.top()), std::min(corner.column(), range.left()));
  const auto firstRow = static_cast<std::size_t>(corner.isValid() ? corner.row() : m_model.readingCount());
  if (const auto named = namedBlock(block)) {
    if (!named->problem.isEmpty()) {
      emit remark(tr("The clipboard was not pasted: %1.").arg(visibleLine(named->problem)));
      return;
    }
    m_editor.paste(named->rows, firstRow, named->columns);
    if (!named->unplaced.isEmpty())
      emit remark(tr("Columns of the clipboard that were not pasted: %1.")
                      .arg(shortLine(listText(named->unplaced), 200)));
    return;
  }
  if (!corner.isValid())
    corner = m_model.index(m_model.readingCount(), static_cast<int>(ReadingColumn::Horizontal));
  const std::size_t left =
      m_editor.paste(block, static_cast<std::size_t>(corner.row()), columnsFrom(corner.column()));
  if (left > 0)
    emit remark(left == 1
                    ? tr("The last column of the clipboard did not fit and was not pasted.")
                    : tr("The last %1 columns of the clipboard did not fit and were not pasted.").arg(left));
}

void ReadingsTable::clearCells() {
  m_editor.clear(selectedCells());
}

void ReadingsTable::insertAbove() {
  const int row = std::clamp(currentIndex().row(), 0, m_model.readingCount());
  m_editor.insertBlank(static_cast<std::size_t>(row));
  selectCell(row, ReadingColumn::Horizontal);
}

void ReadingsTable::layOut(FurtherRows which) {
  const int first = m_model.readingCount();
  m_editor.layOut(which);
  if (m_model.readingCount() > first) selectCell(first, ReadingColumn::Horizontal);
}

void ReadingsTable::deleteSelected() {
  const QModelIndex current = currentIndex();
  m_editor.remove(selectedRows());
  if (current.isValid()) selectCell(current.row(), columnOf(current));
}

void ReadingsTable::toggleExcluded() {
  const std::vector<std::size_t> rows = selectedRows();
  if (rows.empty()) return;
  const QModelIndex first = m_model.index(static_cast<int>(rows.front()), 0);
  const bool excludes = !first.data(ReadingsModel::ExcludedRole).toBool();
  m_editor.setExcluded(rows, excludes);
  if (excludes) askReason(rows);
}

}  // namespace alidade::ui
