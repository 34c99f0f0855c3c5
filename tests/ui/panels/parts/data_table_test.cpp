#include "ui/panels/parts/data_table.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QHeaderView>

namespace alidade::ui {
namespace {

std::vector<DataColumn> columnsWithCells(const QString& cell) {
  std::vector<DataColumn> columns;
  for (const char* title : {"Horizontal", "Redundancy", "Smallest error found", "Point"})
    columns.push_back({QString::fromLatin1(title), {}, {}, [cell](int) { return cell; }});
  return columns;
}

/// However little room there is, every word of the header is whole.
TEST(DataTable, WrapsTheTitlesOfNarrowColumns) {
  for (const int width : {120, 260, 2000}) {
    DataTable table(columnsWithCells(QStringLiteral("1")));
    table.setRows(3);
    table.resize(width, 300);
    table.show();
    QCoreApplication::processEvents();
    const QHeaderView& header = *table.horizontalHeader();
    for (int column = 0; column < header.count(); ++column) {
      const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
      const QRect cell(0, 0, header.sectionSize(column), header.height());
      const QRect text = table.fontMetrics().boundingRect(cell, Qt::AlignCenter | Qt::TextWordWrap, title);
      EXPECT_TRUE(cell.contains(text)) << title.toStdString() << " in " << width;
    }
  }
}

TEST(DataTable, KeepsItsHeaderOnOneLineWhereThereIsRoom) {
  DataTable table(columnsWithCells(QStringLiteral("1")));
  table.setRows(3);
  table.resize(2000, 300);
  table.show();
  QCoreApplication::processEvents();
  EXPECT_LT(table.horizontalHeader()->height(), 2 * table.fontMetrics().height());
}

}  // namespace
}  // namespace alidade::ui
