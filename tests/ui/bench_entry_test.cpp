#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModel>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStatusBar>
#include <QTabBar>
#include <QTest>
#include <algorithm>

#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/entry/bench_display.h"
#include "ui/entry/entry_guide.h"
#include "ui/main_window.h"
#include "ui/models/readings_model.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/text/entry_text.h"

// Types a session as at the instrument: by keyboard alone, with the eyes on the circles.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

/// Types into the focused widget.
void type(const QString& text, Qt::Key key = Qt::Key_Return) {
  typeInto(*QApplication::focusWidget(), text, key);
}

std::string focusName() {
  const QWidget* focus = QApplication::focusWidget();
  return focus ? focus->objectName().toStdString() : "nothing";
}

void press(MainWindow& window, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
  QTest::keyClick(&window, key, modifiers);
  QCoreApplication::processEvents();
}

struct EntryBench {
  OpenWindow open;

  EntryBench() { QApplication::setActiveWindow(open.window.get()); }

  const Session& session() { return open->document().session(); }
  ReadingsTable& table() { return *open->currentTable(); }
  int currentColumn() { return table().currentIndex().column(); }
  void start(const Session& session) {
    open->document().startWith(session);
    open.waitUntilIdle();
    QCoreApplication::processEvents();
  }
};

constexpr int horizontalColumn = static_cast<int>(ReadingColumn::Horizontal);

TEST(BenchEntry, APaperSessionIsTypedWithoutTheMouse) {
  const Session paper = paperSession();
  EntryBench bench;
  EXPECT_EQ(focusName(), "geometry.distance_mm") << "where typing begins";
  type(qText(paper.geometry.distanceMm));
  EXPECT_EQ(focusName(), "geometry.sigma_distance_mm");
  type({});
  type(qText(paper.geometry.radiusMm));
  press(*bench.open.window, Qt::Key_F6);
  for (const std::size_t position : {0U, 1U}) {
    if (position == 1) press(*bench.open.window, Qt::Key_1, Qt::AltModifier);
    const Position& read = paper.positions[position];
    EXPECT_EQ(focusName(), "pointing_zero.horizontal " + std::to_string(position));
    type(qText(read.zero.horizontal));
    type(qText(read.zero.vertical));
    EXPECT_EQ(focusName(), "readings" + std::to_string(position)) << "past the axis, which is right";
    for (const Reading& row : read.readings) {
      type(qText(row.horizontal));
      type(qText(row.vertical));
    }
  }
  bench.open.waitUntilIdle();
  for (const std::size_t position : {0U, 1U}) {
    const Position &typed = bench.session().positions[position], &read = paper.positions[position];
    EXPECT_EQ(typed.zero.horizontal, read.zero.horizontal);
    ASSERT_EQ(typed.readings.size(), read.readings.size());
    for (std::size_t row = 0; row < read.readings.size(); ++row) {
      EXPECT_EQ(typed.readings[row].point, read.readings[row].point);
      EXPECT_EQ(typed.readings[row].horizontal, read.readings[row].horizontal);
      EXPECT_EQ(typed.readings[row].vertical, read.readings[row].vertical);
    }
  }
}

/// At scale 2, a screen of 1920 × 1080 pixels has half of each for the window, less its frame and title.
TEST(BenchEntry, TheWindowFitsASmallScreenAtScaleTwo) {
  EntryBench bench;
  bench.start(paperSession());
  EXPECT_LE(bench.open->minimumSizeHint().width(), 960 - 16);
  EXPECT_LE(bench.open->minimumSizeHint().height(), 540 - 40);
}

TEST(BenchEntry, TabFromTheAxisReachesTheFirstReading) {
  EntryBench bench;
  Session session = paperSession();
  for (Position& position : session.positions) position.readings.clear();
  bench.start(session);
  bench.open->reveal({.position = 0, .field = "axis_deg"});
  ASSERT_EQ(focusName(), "axis_deg 0");
  for (int i = 0; i < 5 && QApplication::focusWidget() != &bench.table(); ++i)
    press(*bench.open.window, Qt::Key_Tab);
  EXPECT_EQ(focusName(), "readings0");
  EXPECT_EQ(bench.currentColumn(), horizontalColumn);
  EXPECT_EQ(bench.table().currentIndex().row(), 0);
}

TEST(BenchEntry, AltAndADigitLeadToTheReadingsFromAnywhere) {
  EntryBench bench;
  bench.start(sessionTakenAt({0, 180, 0}));
  auto& tabs = *bench.open->findChild<PositionTabs*>();
  const auto press0 = [&] { press(*bench.open.window, Qt::Key_0, Qt::AltModifier); };
  tabs.setCurrentIndex(1);
  bench.open->pageTabs().first()->tabBar()->setFocus();
  press0();
  EXPECT_EQ(tabs.currentIndex(), 0);
  EXPECT_EQ(QApplication::focusWidget(), &bench.table());
  press0();
  EXPECT_EQ(tabs.currentIndex(), 2) << "on to the next position at that axis";
  press0();
  EXPECT_EQ(tabs.currentIndex(), 0);
  press(*bench.open.window, Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(tabs.currentIndex(), 1);
}

TEST(BenchEntry, TheNextEntryIsAMissingPointingZeroAndIsSaidAlike) {
  EntryBench bench;
  Session session = paperSession();
  session.positions[1].zero.horizontal.clear();
  bench.start(session);
  EXPECT_THAT(bench.open->statusBar()->findChildren<QLabel*>(),
              testing::Contains(testing::Truly([](const QLabel* label) {
                return label->text() == QStringLiteral("Next: 180°: pointing zero");
              })));
  bench.open->currentTable()->setFocus();
  press(*bench.open.window, Qt::Key_F6);
  EXPECT_EQ(focusName(), "pointing_zero.horizontal 1");
}

TEST(BenchEntry, BehindTheLastRowTheNextEntryIsTheZeroOfTheNextPosition) {
  EntryBench bench;
  Session session = paperSession();
  session.positions[1].zero = {};
  session.positions[1].readings.clear();
  bench.start(session);
  for (const char* from : {"geometry.distance_mm", "notes", "pointing_zero.vertical"}) {
    const bool isOfPosition = std::string(from).starts_with("pointing");
    bench.open->reveal(
        {.position = isOfPosition ? std::optional<std::size_t>(0) : std::nullopt, .field = from});
    press(*bench.open.window, Qt::Key_F6);
    EXPECT_EQ(focusName(), "pointing_zero.horizontal 1") << from;
    bench.open->reveal({.position = 0, .field = "pointing_zero.horizontal"});
  }
}

TEST(BenchEntry, ADayIsPutAsTheSessionHasIt) {
  EntryBench bench;
  bench.start(paperSession());
  changeField(bench.open->document(), {.field = "measured_on"}, "1.3.2026");
  EXPECT_EQ(bench.session().measuredOn, "2026-03-01");
}

TEST(BenchEntry, DigitsTypedWhereNothingTakesThemGoToTheNextEntry) {
  EntryBench bench;
  Session session = paperSession();
  session.positions[0].readings[4].vertical.clear();
  bench.start(session);
  QWidget* nowhere = bench.open->pageTabs().last()->tabBar();
  nowhere->setFocus();
  QTest::keyClicks(nowhere, QStringLiteral("8"));
  ASSERT_TRUE(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("24039"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(bench.session().positions[0].readings[4].vertical, "824039");
}

TEST(BenchEntry, ACellThatTakesNoNumbersSaysSo) {
  EntryBench bench;
  bench.start(paperSession());
  bench.table().setFocus();
  bench.table().selectCell(2, ReadingColumn::HorizontalResidual);
  QTest::keyClicks(&bench.table(), QStringLiteral("3"));
  EXPECT_THAT(bench.open->statusBar()->currentMessage().toStdString(), HasSubstr("takes no numbers"));
  EXPECT_EQ(bench.session(), paperSession());
}

TEST(BenchEntry, AReadingFarFromWhatIsExpectedIsMarkedAtOnce) {
  EntryBench bench;
  Session session = paperSession();
  const std::string right = session.positions[1].readings[6].vertical;
  session.positions[1].readings.resize(6);
  bench.start(session);
  press(*bench.open.window, Qt::Key_1, Qt::AltModifier);
  const auto* next = bench.open->findChild<QLabel*>(QStringLiteral("next reading"));
  EXPECT_THAT(next->text().toStdString(), HasSubstr("point 7, about 335°4"));
  type(qText(paperSession().positions[1].readings[6].horizontal));
  bench.open.waitUntilIdle();
  type(QStringLiteral("88 57 26"));  // the paper has 98 57 26
  QCoreApplication::processEvents();
  const auto doubt = [&] {
    return bench.table()
        .model()
        ->index(6, static_cast<int>(ReadingColumn::Vertical))
        .data(ReadingsModel::SuspectRole);
  };
  EXPECT_THAT(doubt().toString().toStdString(), HasSubstr("was read where about 99°"));
  EXPECT_THAT(bench.open->statusBar()->currentMessage().toStdString(), HasSubstr("Look again"));
  bench.open.waitUntilIdle();
  ReadingsEditor(bench.open->document(), 1).setCell({6, ReadingColumn::Vertical}, right);
  bench.open.waitUntilIdle();
  EXPECT_EQ(doubt().toString(), QString());
}

TEST(BenchEntry, TheWayBackIsLaidOutInOneStep) {
  EntryBench bench;
  bench.start(paperSession());
  bench.table().layOut(FurtherRows::WayBackInTwo);
  const auto& rows = bench.session().positions[0].readings;
  ASSERT_EQ(rows.size(), 34U);
  EXPECT_EQ(rows[17].point, "17");
  EXPECT_EQ(rows[17].face, "2");
  EXPECT_EQ(bench.table().currentIndex().row(), 17);
  bench.open.waitUntilIdle();
  const auto* next = bench.open->findChild<QLabel*>(QStringLiteral("next reading"));
  EXPECT_THAT(next->text().toStdString(), HasSubstr("point 17, round 2, face 2, about 143°"));
  bench.open->undo();
  EXPECT_EQ(bench.session(), paperSession());
}

TEST(BenchEntry, TheLargeDisplayShowsWhatIsNext) {
  EntryBench bench;
  Session session = paperSession();
  session.positions[1].readings.resize(9);
  bench.start(session);
  bench.open->entry().setLargeDisplayShown(true);
  press(*bench.open.window, Qt::Key_1, Qt::AltModifier);
  const auto* display = bench.open->findChild<BenchDisplay*>();
  std::string texts;
  for (const QLabel* label : display->findChildren<QLabel*>()) texts += label->text().toStdString() + "\n";
  EXPECT_THAT(texts, HasSubstr("180°: Point 10"));
  EXPECT_THAT(texts, HasSubstr("Δd, "));
  EXPECT_THAT(texts, HasSubstr("330°"));
}

TEST(BenchEntry, TheLargeDisplayForgetsADoubtWithItsReading) {
  const Session paper = paperSession();
  for (const bool isCorrected : {true, false}) {
    EntryBench bench;
    Session session = paper;
    session.positions[1].readings.resize(9);
    bench.start(session);
    bench.open->entry().setLargeDisplayShown(true);
    press(*bench.open.window, Qt::Key_1, Qt::AltModifier);
    const auto* display = bench.open->findChild<BenchDisplay*>();
    const auto isDoubted = [&] {
      const auto labels = display->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().contains(QStringLiteral("Look again"));
      });
    };
    const auto typeInto = [&](const std::string& text) {
      QAbstractItemModel& model = *bench.table().model();
      model.setData(model.index(9, horizontalColumn), qText(text));
      bench.open.waitUntilIdle();
      QCoreApplication::processEvents();
    };
    typeInto("10 00 00");
    EXPECT_TRUE(isDoubted());
    if (isCorrected)
      typeInto(paper.positions[1].readings[9].horizontal);
    else
      bench.start(paper);
    EXPECT_FALSE(isDoubted()) << isCorrected;
  }
}

TEST(BenchEntry, TheLargeDisplayHasTheMeasuredResultAloneInLargeType) {
  EntryBench bench;
  bench.start(paperSession());
  bench.open->entry().setLargeDisplayShown(true);
  const auto* display = bench.open->findChild<BenchDisplay*>();
  const auto labelWith = [&](const char* text) -> const QLabel* {
    for (const QLabel* label : display->findChildren<QLabel*>())
      if (label->text().contains(QString::fromUtf8(text))) return label;
    return nullptr;
  };
  const auto isQuiet = [&](const QLabel* label) {
    return label->palette().color(QPalette::WindowText) == stateColor(display->palette(), State::Quiet);
  };
  ASSERT_FALSE(bench.open->gapJob().isIdle()) << "the diagnosis waits for half a second of rest";
  ASSERT_TRUE(labelWith("Provisional: the diagnosis is running.") && labelWith("Δd, fit only = 1.31"));
  EXPECT_TRUE(isQuiet(labelWith("Provisional: the diagnosis is running.")));
  EXPECT_TRUE(isQuiet(labelWith("Δd, fit only = 1.31")));
  ASSERT_TRUE(waitFor([&] { return bench.open->gapJob().isIdle(); }));
  const QLabel* measured = labelWith("Δd = 1.24 ± 0.79 mm");
  const QLabel* verdict = labelWith("Accepted · tolerance ± 2.5 mm");
  const QLabel* below = labelWith("Across the plane of the arc: Δz = ");
  ASSERT_TRUE(measured && verdict && below);
  EXPECT_FALSE(isQuiet(measured) || isQuiet(verdict));
  EXPECT_LT(measured->y(), verdict->y());
  EXPECT_LT(verdict->y(), below->y());
  EXPECT_LT(1.5 * below->font().pixelSize(), verdict->font().pixelSize());
  EXPECT_LE(verdict->font().pixelSize(), measured->font().pixelSize());
}

TEST(BenchEntry, GonIsTypedAndShownWhereTheInstrumentHasIt) {
  EntryBench bench;
  Session session = paperSession();
  session.instrument.angleUnit = "gon";
  bench.start(session);
  const auto shown = [&](int row) {
    return bench.table().model()->index(row, horizontalColumn).data().toString().toStdString();
  };
  EXPECT_EQ(shown(0), "379.85926 gon");
  press(*bench.open.window, Qt::Key_0, Qt::AltModifier);
  type(QStringLiteral("358.1234"));
  EXPECT_EQ(bench.session().positions[0].readings.back().horizontal, "358.1234gon");
  bench.open.waitUntilIdle();
  EXPECT_EQ(shown(17), "358.12340 gon") << "as finely as the others";
  changeField(bench.open->document(), {.field = "instrument.angle_unit"}, "degrees");
  bench.open.waitUntilIdle();
  EXPECT_EQ(shown(0), "341.87333°");
}

}  // namespace
}  // namespace alidade::ui
