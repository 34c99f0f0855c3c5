#include "ui/panels/parts/figure_grid.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

namespace alidade::ui {
namespace {

QLabel* labelOf(const FigureGrid& grid, const QString& text) {
  for (QLabel* label : grid.findChildren<QLabel*>())
    if (label->text() == text && label->isVisibleTo(&grid)) return label;
  return nullptr;
}

TEST(FigureGrid, LetsItsFiguresBeSelected) {
  FigureGrid grid;
  grid.setRows({QStringLiteral("mm")}, {{QStringLiteral("Δd"), {QStringLiteral("131")}}});
  grid.show();
  QLabel* figure = labelOf(grid, QStringLiteral("131"));
  ASSERT_TRUE(figure);
  EXPECT_FALSE(figure->hasSelectedText());
  QTest::mouseDClick(figure, Qt::LeftButton, {}, QPoint(figure->width() - 4, figure->height() / 2));
  EXPECT_EQ(figure->selectedText(), QStringLiteral("131"));
}

TEST(FigureGrid, ShowsNoMoreThanItsNewestRows) {
  FigureGrid grid;
  const auto row = [](const char* caption, const char* figure) {
    return FigureGrid::Row{QString::fromLatin1(caption), {QString::fromLatin1(figure)}};
  };
  grid.setRows({QStringLiteral("mm")}, {row("one", "1"), row("two", "2")});
  EXPECT_TRUE(labelOf(grid, QStringLiteral("two")));
  grid.setRows({QStringLiteral("mm")}, {row("three", "3")});
  EXPECT_TRUE(labelOf(grid, QStringLiteral("3")));
  EXPECT_FALSE(labelOf(grid, QStringLiteral("one")));
  EXPECT_FALSE(labelOf(grid, QStringLiteral("two")));
}

}  // namespace
}  // namespace alidade::ui
