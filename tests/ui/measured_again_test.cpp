// Repeated positions (0°, 180°, 0°), from the menu to the pages.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

#include "core/simulation/simulate.h"
#include "core/wording/size_text.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/main_window.h"
#include "ui/panels/parts/data_table.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/result_panel.h"
#include "ui/panels/uncertainty/budget_panel.h"
#include "ui/panels/uncertainty/reliability_panel.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> tabsOf(OpenWindow& open) {
  const auto* tabs = open->findChild<PositionTabs*>();
  std::vector<std::string> titles;
  for (int tab = 0; tab < tabs->count(); ++tab)
    if (tabs->isTabVisible(tab)) titles.push_back(tabs->tabText(tab).remove(QLatin1Char('&')).toStdString());
  return titles;
}

std::string textsOf(const QWidget& page) {
  QString texts;
  for (const QLabel* label : page.findChildren<QLabel*>())
    if (label->isVisibleTo(&page)) texts += label->text() + QLatin1Char('\n');
  return texts.toStdString();
}

void measureAgain(OpenWindow& open, int axisDeg) {
  open->findChild<QAction*>(QStringLiteral("add position %1").arg(axisDeg))->trigger();
  open.waitUntilIdle();
}

/// Types the readings of another session into a position of the window, row by row.
void typePosition(OpenWindow& open, std::size_t position, const Position& source, std::size_t count) {
  const auto zero = [&](const char* field) {
    return open->findChild<QLineEdit*>(
        QStringLiteral("pointing_zero.%1 %2").arg(QLatin1String(field)).arg(position));
  };
  typeInto(*zero("horizontal"), QString::fromStdString(source.zero.horizontal));
  typeInto(*zero("vertical"), QString::fromStdString(source.zero.vertical));
  ReadingsTable& table = *open->findChild<PositionTabs*>()->table(position);
  table.selectCell(0, ReadingColumn::Horizontal);
  for (std::size_t row = 0; row < count; ++row) {
    typeInto(table, QString::fromStdString(source.readings[row].horizontal));
    typeInto(table, QString::fromStdString(source.readings[row].vertical));
  }
}

TEST(MeasuredAgain, IsTypedFittedSavedAndOpened) {
  for (const int axisDeg : {0, 180}) {
    const Session whole = sessionTakenAt({0, 180, axisDeg});
    Session two = whole;
    two.positions.pop_back();
    const QTemporaryDir folder;
    OpenWindow open;
    open->document().startWith(two);
    open.waitUntilIdle();
    EXPECT_THAT(tabsOf(open), ElementsAre("Axis at 0°", "Axis at 180°"));
    measureAgain(open, axisDeg);
    const std::string name = std::to_string(axisDeg) + "° again";
    EXPECT_THAT(tabsOf(open), ElementsAre("Axis at 0°", "Axis at 180°", name));
    EXPECT_EQ(open->findChild<PositionTabs*>()->currentIndex(), 2);
    EXPECT_TRUE(open->findChild<QLineEdit*>(QStringLiteral("pointing_zero.horizontal 2"))->hasFocus());
    EXPECT_TRUE(open->document().session().positions[2].zero.horizontal.empty());
    expectAllVisible(*open.window, QStringLiteral("with a position added"));
    typePosition(open, 2, whole.positions[2], 17);
    open.waitUntilIdle();
    const auto& positions = open->document().session().positions;
    ASSERT_EQ(positions[2].readings.size(), 17u);
    for (std::size_t row = 0; row < 17; ++row)
      EXPECT_EQ(positions[2].readings[row].vertical, whole.positions[2].readings[row].vertical);
    const Intersection wanted = *evaluate(whole).fit.intersection;
    EXPECT_THAT(textsOf(*open->findChild<ResultPanel*>()),
                HasSubstr(sizeWithExpanded(wanted.value, wanted.expanded, "mm")));

    open.dialogs->savePath = folder.filePath(QStringLiteral("again.alidade"));
    ASSERT_TRUE(open->files().saveAs());
    OpenWindow other;
    ASSERT_TRUE(other->files().open(open.dialogs->savePath));
    other.waitUntilIdle();
    EXPECT_EQ(other->document().session(), open->document().session());
    EXPECT_THAT(tabsOf(other), ElementsAre("Axis at 0°", "Axis at 180°", name));
    for (OpenWindow* window : {&open, &other})
      ASSERT_TRUE(waitFor([&] { return (*window)->gapJob().isIdle(); }));
    EXPECT_EQ(textsOf(*other->findChild<ResultPanel*>()).substr(0, 40),
              textsOf(*open->findChild<ResultPanel*>()).substr(0, 40));
  }
}

// The window is consistent after every cell, and shows the result of two positions until the third has an
// arc.
TEST(MeasuredAgain, IsNoTroubleHalfTyped) {
  const Session whole = sessionTakenAt({0, 180, 0});
  Session two = whole;
  two.positions.pop_back();
  OpenWindow open;
  open->document().startWith(two);
  open.waitUntilIdle();
  measureAgain(open, 0);
  const std::string result = textsOf(*open->findChild<ResultPanel*>());
  EXPECT_THAT(result, HasSubstr("Δd, fit only = ")) << "the new position is still empty";
  typePosition(open, 2, whole.positions[2], 1);
  open.waitUntilIdle();
  EXPECT_THAT(textsOf(*open->findChild<ResultPanel*>()), HasSubstr("Sightings\n17\n17\n"));
  auto& table = *open->findChild<PositionTabs*>()->table(2);
  table.selectCell(1, ReadingColumn::Horizontal);
  table.setFocus();
  QTest::keyClicks(&table, QStringLiteral("3"));
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("4"));
  measureAgain(open, 0);
  EXPECT_EQ(open->document().session().positions[2].readings.at(1).horizontal, "34") << "is handed in";
  EXPECT_THAT(tabsOf(open), ElementsAre("Axis at 0°", "Axis at 180°", "0° again", "0° again (3)"));
  for (int steps = open->document().undoStack().count(); steps > 0; --steps) open->undo();
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session(), two);
  EXPECT_THAT(tabsOf(open), ElementsAre("Axis at 0°", "Axis at 180°"));
  for (int steps = open->document().undoStack().count(); steps > 0; --steps) open->redo();
  open.waitUntilIdle();
  EXPECT_EQ(tabsOf(open).size(), 4u);
}

TEST(MeasuredAgain, IsCountedAmongTheFiguresOfItsAxis) {
  OpenWindow open;
  open->document().startWith(sessionTakenAt({0, 180, 0, 0}));
  open.waitUntilIdle();
  const auto* page = open->findChild<ResultPanel*>();
  EXPECT_THAT(textsOf(*page), HasSubstr("Sightings\n51\n17\n"));
  QStringList tips;
  for (const QLabel* label : page->findChildren<QLabel*>()) tips.append(label->toolTip());
  EXPECT_TRUE(tips.contains(QStringLiteral("0°: 17\n0° again: 17\n0° again (3): 17")))
      << tips.join(u'|').toStdString();
}

TEST(MeasuredAgain, HasTheMeanOfWhatThePublishedMethodFinds) {
  OpenWindow open;
  open->document().startWith(sessionTakenAt({0, 180, 0}));
  open.waitUntilIdle();
  auto* page = open->findChild<ResultPanel*>();
  page->findChild<QCheckBox*>()->click();
  const PublishedSessionFit published =
      fitSessionAsPublished(*examine(open->document().session()).measurement);
  ASSERT_EQ(published.arcs.size(), 3u);
  const auto y = [&](std::size_t arc) { return published.arcs[arc].asPrinted.y; };
  ASSERT_EQ(published.arcs[1].arc.axisDeg, 180);
  const QString shown =
      QStringLiteral("Δy (mm)\n%1\n%2\n").arg(numberText((y(0) + y(2)) / 2, 4), numberText(y(1), 4));
  EXPECT_THAT(textsOf(*page), HasSubstr(shown.toStdString()));
  EXPECT_NEAR(*published.intersectionAsPrinted, ((y(0) + y(2)) / 2 - y(1)) / 2, 1e-12);
}

// Many readings reduce u to a few micrometres, which need more decimals; a new position gives a long verdict.
TEST(MeasuredAgain, FitsTheWidthOfTheResult) {
  OpenWindow open;
  open->resize(1280, 800);
  open->document().startWith(*simulate(*protocolByName("full-again"), drawTruth(5), 5));
  open.waitUntilIdle();
  measureAgain(open, 180);
  const std::size_t last = open->document().session().positions.size() - 1;
  changeField(open->document(), {.position = last, .field = "pointing_zero.horizontal"}, "90");
  open.waitUntilIdle();
  const auto* page = open->findChild<ResultPanel*>();
  ASSERT_THAT(textsOf(*page), HasSubstr("No verdict: 1 entry could not be used"));
  EXPECT_LE(page->widget()->minimumSizeHint().width(), page->viewport()->width());
}

TEST(MeasuredAgain, IsNamedOnThePages) {
  OpenWindow open;
  Session session = sessionTakenAt({0, 180, 0, 180});
  session.positions[2].readings[4].vertical = "x";
  open->document().startWith(session);
  open.waitUntilIdle();
  for (PageTabs* tabs : open->pageTabs())
    for (int page = 0; page < tabs->count(); ++page) {
      tabs->showPage(page);
      QCoreApplication::processEvents();
    }
  QString texts;
  for (const ShownText& shown : shownTexts(*open.window)) texts += shown.text + u'\n';
  EXPECT_TRUE(texts.contains(QStringLiteral("0° again, row 5 (point 5)"))) << "the entry that means nothing";
  const auto* reliability = open->findChild<ReliabilityPanel*>()->findChild<DataTable*>();
  const auto axisAt = [&](int row) { return reliability->model()->index(row, 0).data().toString(); };
  EXPECT_EQ(axisAt(0), QStringLiteral("0°"));
  const int readings = reliability->model()->rowCount() - 9;  // two zeros of each position, the distance
  EXPECT_EQ(axisAt(readings - 1), QStringLiteral("180° again"));
  EXPECT_EQ(axisAt(readings + 7), QStringLiteral("180° again")) << "its vertical zero";
  EXPECT_EQ(axisAt(readings + 8), QStringLiteral("—")) << "the distance is that of all";
  const std::string budget = textsOf(*open->findChild<BudgetPanel*>());
  EXPECT_THAT(budget, HasSubstr("\nΔx 0°\nΔy 0°\nΔx 180°\nΔy 180°\n"));
  EXPECT_THAT(budget, Not(HasSubstr("Δy 180°\nΔx"))) << "centres once for each axis";
}

}  // namespace
}  // namespace alidade::ui
