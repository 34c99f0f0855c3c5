#include "ui/dialogs/command_palette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>

#include "tests/ui/support.h"
#include "ui/main_window.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

QStringList listed(const CommandPalette& palette) {
  QStringList texts;
  const auto* list = palette.findChild<QListWidget*>();
  for (int i = 0; i < list->count(); ++i) texts.append(list->item(i)->text());
  return texts;
}

void countCommands(const QMenu& menu, int& count) {
  for (const QAction* action : menu.actions()) {
    if (action->menu())
      countCommands(*action->menu(), count);
    else if (!action->isSeparator() && action->isVisible() && action->isEnabled())
      ++count;
  }
}

TEST(CommandPalette, HoldsEveryCommandOfTheMenusThatCanBeGiven) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  const CommandPalette palette(*open->menuBar(), open.window.get());
  int count = 0;
  for (const QAction* action : open->menuBar()->actions()) {
    emit action->menu()->aboutToShow();
    countCommands(*action->menu(), count);
    emit action->menu()->aboutToHide();
  }
  EXPECT_GT(count, 40);
  EXPECT_EQ(listed(palette).size(), count);
  for (const QString& text : listed(palette)) EXPECT_FALSE(text.contains(u'&')) << text.toStdString();
}

TEST(CommandPalette, IsNarrowedDownByTheBeginningsOfWords) {
  OpenWindow open;
  open->document().startWith(paperSession());
  CommandPalette palette(*open->menuBar(), open.window.get());
  auto* line = palette.findChild<QLineEdit*>();
  line->setText(QStringLiteral("ro ret ru"));
  ASSERT_EQ(listed(palette).size(), 2);
  EXPECT_THAT(listed(palette)[0].toStdString(), HasSubstr("Edit › Add Rows › Return Run"));
  line->setText(QStringLiteral("eturn"));
  EXPECT_TRUE(listed(palette).isEmpty()) << "no word begins so";
  line->setText(QStringLiteral("save"));
  EXPECT_THAT(listed(palette).join(u'\n').toStdString(), HasSubstr("Ctrl+S"));
}

TEST(CommandPalette, DoesWhatIsChosenWithTheKeyboard) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  CommandPalette palette(*open->menuBar(), open.window.get());
  QTimer::singleShot(0, &palette, [&] {
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClicks(line, QStringLiteral("return run"));
    QTest::keyClick(line, Qt::Key_Down);
    QTest::keyClick(line, Qt::Key_Return);
  });
  QAction* chosen = palette.ask();
  ASSERT_TRUE(chosen);
  chosen->trigger();
  const auto& rows = open->document().session().positions[0].readings;
  ASSERT_EQ(rows.size(), 34U);
  EXPECT_EQ(rows.back().face, "2") << "the second of two";
  QTimer::singleShot(0, &palette, [&] { QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Escape); });
  EXPECT_EQ(palette.ask(), nullptr);
}

}  // namespace
}  // namespace alidade::ui
