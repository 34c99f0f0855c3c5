#include "ui/dialogs/difference_table.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QTreeWidget>
#include <algorithm>

#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct DifferenceText {
  Q_DECLARE_TR_FUNCTIONS(DifferenceText)
};

QString orNothing(const QString& text) {
  return text.isEmpty() ? QStringLiteral("—") : visibleLine(text);
}

}  // namespace

QTreeWidget* createDifferenceTable(const SessionDifference& difference, const QString& mine,
                                   const QString& theirs) {
  auto* table = new QTreeWidget;
  table->setHeaderLabels({DifferenceText::tr("Entry"), mine, theirs});
  table->setRootIsDecorated(false);
  table->setUniformRowHeights(true);
  table->setAlternatingRowColors(true);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  QList<QTreeWidgetItem*> rows;
  for (const EntryDifference& entry : difference.entries)
    rows.append(
        new QTreeWidgetItem({visibleLine(entry.where), orNothing(entry.mine), orNothing(entry.theirs)}));
  const std::size_t more = difference.count - difference.entries.size();
  if (more > 0) rows.append(new QTreeWidgetItem({DifferenceText::tr("and %1 more").arg(more)}));
  table->addTopLevelItems(rows);
  constexpr int margin = 14, widest = 260;
  for (int column = 0; column < table->columnCount(); ++column) {
    table->resizeColumnToContents(column);
    table->setColumnWidth(column, std::min(table->columnWidth(column) + margin, widest));
  }
  table->header()->setStretchLastSection(true);
  return table;
}

}  // namespace alidade::ui
