#include "ui/settings/window_font.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QTableView>
#include <algorithm>

#include "tests/ui/support.h"
#include "ui/charts/plotting/caption.h"
#include "ui/main_window.h"
#include "ui/panels/result/result_panel.h"
#include "ui/window/entry_column.h"

namespace alidade::ui {
namespace {

class WindowFontTest : public testing::Test {
 protected:
  ~WindowFontTest() override {
    QApplication::setFont(m_before);
    QSettings().remove(QStringLiteral("font"));
  }

  QFont m_before = QApplication::font();
};

TEST_F(WindowFontTest, IsTheDesktopsUnlessAnotherIsChosen) {
  const QFont desktop = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  EXPECT_EQ(rememberedFont(), FontChoice());
  EXPECT_EQ(fontOf({}), desktop);
  EXPECT_EQ(fontOf({.points = 14}).families(), desktop.families()) << "its letters, larger";
  EXPECT_DOUBLE_EQ(fontOf({.points = 14}).pointSizeF(), 14);
  EXPECT_EQ(fontOf({.family = QStringLiteral("DejaVu Serif")}).family(), QStringLiteral("DejaVu Serif"));
}

TEST_F(WindowFontTest, IsRememberedAndKeptReadable) {
  const FontChoice chosen{.family = QStringLiteral("DejaVu Serif"), .points = 12};
  applyFont(chosen);
  EXPECT_EQ(rememberedFont(), chosen);
  EXPECT_EQ(QApplication::font().family(), chosen.family);
  EXPECT_EQ(resized(chosen, 1), (FontChoice{chosen.family, 13}));
  EXPECT_EQ(resized({.points = largestPoints}, 1).points, largestPoints);
  EXPECT_EQ(resized({.points = smallestPoints}, -1).points, smallestPoints);
  QSettings().setValue(QStringLiteral("font/points"), 1e6);
  EXPECT_EQ(rememberedFont().points, largestPoints) << "whatever the settings say";
  applyFont({});
  EXPECT_EQ(rememberedFont(), FontChoice());
}

TEST_F(WindowFontTest, IsResizedInTheMenu) {
  OpenWindow open;
  const auto trigger = [&](const char* text) {
    for (const QMenu* menu : open->findChildren<QMenu*>())
      for (QAction* action : menu->actions())
        if (action->text().remove(u'&') == QString::fromUtf8(text)) return action->trigger();
    FAIL() << text;
  };
  applyFont({QStringLiteral("DejaVu Serif"), 11});
  trigger("Larger Font");
  trigger("Larger Font");
  EXPECT_EQ(rememberedFont().points, 13);
  trigger("Smaller Font");
  EXPECT_EQ(rememberedFont(), (FontChoice{QStringLiteral("DejaVu Serif"), 12}));
}

TEST_F(WindowFontTest, LeavesTheWindowWithinItsScreen) {
  OpenWindow open;
  const int screen = open->screen()->availableGeometry().width();
  applyFont({.points = largestPoints});
  QCoreApplication::processEvents();
  EXPECT_LE(open->minimumSizeHint().width(), std::max(960, screen));
  EXPECT_LE(open->entries().widget()->minimumWidth(), std::max(440, screen * 45 / 100));
  EXPECT_LE(open->findChild<ResultPanel*>()->minimumWidth(), std::max(370, screen * 33 / 100));
}

TEST_F(WindowFontTest, ChangesEveryPartOfAnOpenWindowAtOnce) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  const auto* table = open->findChild<QTableView*>(QStringLiteral("readings0"));
  const auto* caption = open->findChild<Caption*>();
  const auto letters = [&] {
    std::vector<double> sizes;
    for (const QLabel* label : open->findChildren<QLabel*>())
      if (label->isVisible()) sizes.push_back(QFontInfo(label->font()).pointSizeF());
    return sizes;
  };
  const auto angle = [&] { return table->fontMetrics().horizontalAdvance(QStringLiteral("341°52′24″")); };
  applyFont({.points = 9});
  QCoreApplication::processEvents();
  const std::vector<double> before = letters();
  const int row = table->verticalHeader()->sectionSize(0), sentence = caption->fontMetrics().height();
  applyFont({.points = 18});
  QCoreApplication::processEvents();
  const std::vector<double> after = letters();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_NEAR(after[i] / before[i], 2, 0.15) << i << ": whole pixels";
  EXPECT_GT(table->verticalHeader()->sectionSize(0), 1.5 * row);
  EXPECT_GT(caption->fontMetrics().height(), 1.7 * sentence);
  for (int column = 0; column < table->model()->columnCount(); ++column)
    if (table->model()->index(0, column).data().toString().contains(u'″')) {
      EXPECT_GE(table->columnWidth(column), angle()) << column;
    }
}

}  // namespace
}  // namespace alidade::ui
