#include <gtest/gtest.h>

#include <QAccessible>
#include <QAction>
#include <QMenuBar>
#include <QTabWidget>
#include <set>

#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/reading_column.h"
#include "ui/main_window.h"
#include "ui/panels/window/page_tabs.h"

// Tests what a screen reader says: every control that Tab reaches has a name and a role.

namespace alidade::ui {
namespace {

/// Visible controls without a name or role.
void gatherNameless(const QWidget& window, std::set<std::string>& nameless) {
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
    if (accessible && !accessible->text(QAccessible::Name).isEmpty() &&
        accessible->role() != QAccessible::NoRole)
      continue;
    nameless.insert(widget->metaObject()->className() + std::string(" ") +
                    widget->objectName().toStdString() + " in " +
                    widget->parentWidget()->metaObject()->className());
  }
}

TEST(Accessibility, EveryControlOfEveryPageHasANameAndARole) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("two-faces.alidade"))));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  std::set<std::string> nameless;
  for (QTabWidget* tabs : open->findChildren<QTabWidget*>())
    for (int page = 0; page < tabs->count(); ++page) {
      if (!tabs->isTabVisible(page)) continue;
      tabs->setCurrentIndex(page);
      QCoreApplication::processEvents();
      gatherNameless(*open.window, nameless);
    }
  for (const std::string& widget : nameless) ADD_FAILURE() << widget;
}

TEST(Accessibility, CellsOfTheReadingsAreSpokenWithWhatTheyMean) {
  OpenWindow open;
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  QWidget* table = open->findChild<QWidget*>(QStringLiteral("readings0"));
  QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(table);
  ASSERT_TRUE(accessible && accessible->tableInterface());
  EXPECT_EQ(accessible->role(), QAccessible::Table);
  EXPECT_EQ(accessible->tableInterface()->rowCount(), 18) << "and the empty one";
  QAccessibleInterface* cell = accessible->tableInterface()->cellAt(0, 4);
  ASSERT_TRUE(cell);
  EXPECT_EQ(cell->text(QAccessible::Name).toStdString(), "341°52′24″");
  const auto said = [&](int row, int column) {
    return accessible->tableInterface()->cellAt(row, column)->text(QAccessible::Name).toStdString();
  };
  EXPECT_EQ(said(0, static_cast<int>(ReadingColumn::Used)), "used") << "a tick has no text";
  EXPECT_EQ(said(0, static_cast<int>(ReadingColumn::Note)), "Note: empty");
  EXPECT_EQ(said(17, static_cast<int>(ReadingColumn::Horizontal)), "Horizontal α: to be added");
  ReadingsEditor(open->document(), 0).setExcluded({0}, true);
  EXPECT_EQ(said(0, static_cast<int>(ReadingColumn::Used)), "excluded");
}

}  // namespace
}  // namespace alidade::ui
