#include "ui/panels/parts/figure_grid.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QImage>
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

TEST(FigureGrid, TellsWhichRowsAreTicked) {
  FigureGrid grid;
  grid.setRows(
      {QStringLiteral("mm")},
      {{.caption = QStringLiteral("one"), .figures = {}, .tick = QStringLiteral("a"), .isTicked = true},
       {.caption = QStringLiteral("two"), .figures = {}, .tick = QStringLiteral("b")},
       {.caption = QStringLiteral("none"), .figures = {}}});
  EXPECT_EQ(grid.ticked(), QStringList{QStringLiteral("a")});
  ASSERT_EQ(grid.findChildren<QCheckBox*>().size(), 2);
  int changes = 0;
  QObject::connect(&grid, &FigureGrid::ticksChanged, [&] { ++changes; });
  grid.findChild<QCheckBox*>(QStringLiteral("b"))->click();
  EXPECT_EQ(grid.ticked(), (QStringList{QStringLiteral("a"), QStringLiteral("b")}));
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(grid.findChild<QCheckBox*>(QStringLiteral("b"))->accessibleName(), QStringLiteral("two"));
}

/// The width of the stronger part of a bar, as painted.
int paintedBar(double share) {
  FigureGrid grid;
  grid.setRows({QStringLiteral("shrinks")},
               {{.caption = QStringLiteral("one"), .figures = {QStringLiteral(" ")}, .bar = share}}, 0);
  grid.resize(600, 60);
  const QImage image = grid.grab().toImage();
  const QLabel* figure = labelOf(grid, QStringLiteral(" "));
  const int y = figure->geometry().center().y(), left = figure->geometry().left();
  const QColor strong = image.pixelColor(left, y);
  int width = 0;
  while (width < figure->width() && image.pixelColor(left + width, y) == strong) ++width;
  return share > 0 ? 1000 * width / figure->width() : 0;
}

TEST(FigureGrid, DrawsABarInProportion) {
  EXPECT_NEAR(paintedBar(0.5), 500, 10);
  EXPECT_NEAR(paintedBar(0.2), 200, 10);
}

}  // namespace
}  // namespace alidade::ui
