#include "ui/panels/model/known_sizes_table.h"

#include <QHeaderView>
#include <QLineEdit>
#include <algorithm>
#include <memory>

#include "ui/commands/reading_block.h"
#include "ui/document/session_document.h"
#include "ui/panels/parts/cell_delegate.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

namespace {

using Column = KnownSizesModel::Column;

constexpr int firstTyped = static_cast<int>(Column::Value), lastTyped = static_cast<int>(Column::From);

class KnownSizeDelegate : public CellDelegate {
 public:
  using CellDelegate::CellDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    CellDelegate::initStyleOption(option, index);
    if (!index.data(KnownSizesModel::ProblemRole).toString().isEmpty())
      mark(*option, QStringLiteral("problem"), State::Bad);
    else if (index.data(KnownSizesModel::IncompleteRole).toBool())
      markIncomplete(*option);
    if (index.data(KnownSizesModel::QuietRole).toBool()) setQuiet(*option);
  }
};

bool isTyped(const QModelIndex& cell) {
  return cell.flags().testFlag(Qt::ItemIsEditable);
}

}  // namespace

KnownSizesTable::KnownSizesTable(SessionDocument& document, QWidget* parent)
    : EntryTable(new KnownSizeDelegate, parent), m_document(document), m_model(document) {
  setModel(&m_model);
  setAccessibleName(tr("Known sizes of effects"));
  layOutColumns();
  keepCurrentOverResets();
  connect(this, &EntryTable::typed, this, [this](const QLineEdit* editor, const QModelIndex& cell) {
    m_document.halfTyped().set(editor, m_model.halfTyped(cell, editor->text().trimmed()),
                               editor->text() != cell.data(Qt::EditRole).toString());
  });
  connect(this, &EntryTable::typingEnded, &m_document.halfTyped(), &HalfTyped::clear);
  setCurrentIndex(m_model.index(0, firstTyped));
}

void KnownSizesTable::layOutColumns() {
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  QHeaderView* header = horizontalHeader();
  header->setHighlightSections(false);
  header->setMinimumSectionSize(36);
  header->setStretchLastSection(true);
  layOutByFont(*this, [this] {
    const char* const widest[] = {"Horizontal circle eccentricity, cosine ", "instrument", "Default u",
                                  "−1234.56″", "−1234.56″"};
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
    for (int column = 0; column < lastTyped; ++column)
      setColumnWidth(column, fontMetrics().horizontalAdvance(QString::fromUtf8(widest[column])) + 14);
  });
}

/// Adding or removing rows resets the table. Afterwards the same cell is made current again.
void KnownSizesTable::keepCurrentOverResets() {
  const auto before = std::make_shared<std::pair<int, int>>();
  connect(&m_model, &QAbstractItemModel::modelAboutToBeReset, this, [this, before] {
    *before = {currentIndex().row(), currentIndex().column()};
  });
  connect(&m_model, &QAbstractItemModel::modelReset, this, [this, before] {
    reveal(m_model.index(std::min(before->first, m_model.rowCount() - 1), before->second));
  });
}

void KnownSizesTable::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  EntryTable::currentChanged(current, previous);
  emit explanationChanged(current.data(Qt::ToolTipRole).toString());
}

void KnownSizesTable::dataChanged(const QModelIndex& topLeft, const QModelIndex& bottomRight,
                                  const QList<int>& roles) {
  EntryTable::dataChanged(topLeft, bottomRight, roles);
  emit explanationChanged(currentIndex().data(Qt::ToolTipRole).toString());
}

QModelIndex KnownSizesTable::onward(const QModelIndex& from, int key) const {
  if (!from.isValid()) return m_model.index(0, firstTyped);
  return neighbour(from, key == Qt::Key_Backtab ? -1 : 1);
}

/// Copies figures and names as typed, and catalogue texts as shown.
void KnownSizesTable::copy() const {
  ReadingBlock block;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) {
      QStringList cells;
      for (int column = range.left(); column <= range.right(); ++column) {
        const QModelIndex cell = m_model.index(row, column);
        cells.append(cell.data(isTyped(cell) ? Qt::EditRole : Qt::DisplayRole).toString());
      }
      block.append(cells);
    }
  if (!block.isEmpty()) copyBlock(blockText(block));
}

void KnownSizesTable::cut() {
  copy();
  clearCells();
}

void KnownSizesTable::paste() {
  const ReadingBlock block = clipboardBlock();
  const QModelIndex corner = currentIndex();
  if (!isTyped(corner)) return;
  std::vector<NewText> texts;
  for (int i = 0; i < block.size(); ++i)
    for (int j = 0; j < block[i].size(); ++j)
      if (corner.row() + i < m_model.rowCount() && corner.column() + j <= lastTyped)
        texts.push_back({corner.row() + i, corner.column() + j, block[i][j]});
  type(std::move(texts), tr("Paste known sizes"));
}

void KnownSizesTable::clearCells() {
  std::vector<NewText> texts;
  for (const QModelIndex& cell : selectionModel()->selectedIndexes())
    if (isTyped(cell)) texts.push_back({cell.row(), cell.column(), {}});
  type(std::move(texts), tr("Clear known sizes"));
}

/// Enters the texts from the last row to the first, since clearing an entry may remove its row.
void KnownSizesTable::type(std::vector<NewText> texts, const QString& undoText) {
  std::erase_if(texts, [this](const NewText& text) { return !changes(text); });
  std::ranges::stable_sort(texts, std::greater(), &NewText::row);
  const bool isMany = texts.size() > 1;
  if (isMany) m_document.beginTogether(undoText);
  for (const NewText& text : texts)
    m_model.setData(m_model.index(text.row, text.column), text.text, Qt::EditRole);
  if (isMany) m_document.endTogether();
}

/// True if the text changes the session. An empty u counts if it removes an entry that has no text.
bool KnownSizesTable::changes(const NewText& text) const {
  const auto typed = [&](int column) {
    return m_model.index(text.row, column).data(Qt::EditRole).toString();
  };
  if (typed(text.column) != text.text) return true;
  const QModelIndex sigma = m_model.index(text.row, static_cast<int>(Column::Sigma));
  return text.column == sigma.column() && sigma.data(KnownSizesModel::IncompleteRole).toBool() &&
         typed(firstTyped).isEmpty() && typed(lastTyped).isEmpty();
}

}  // namespace alidade::ui
