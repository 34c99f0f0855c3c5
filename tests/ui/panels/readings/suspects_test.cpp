#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLayout>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <algorithm>

#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/models/readings_model.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/readings/suspect_bar.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

constexpr std::size_t slippedRow = 3;

/// The clean sample with an error of ten minutes in its fourth vertical reading at 0°.
struct SuspectBench {
  SuspectBench() {
    if (!open->files().open(samplePath(QStringLiteral("clean-session.alidade"))))
      throw std::runtime_error("sample");
    open.waitUntilIdle();
    typed = readings()[slippedRow].vertical;
    ReadingsEditor(open->document(), 0).setCell({slippedRow, ReadingColumn::Vertical}, slipped());
    open->document().undoStack().clear();
    open.waitUntilIdle();
  }

  const std::vector<Reading>& readings() { return open->document().session().positions[0].readings; }
  SuspectBar& bar() { return *open->findChild<SuspectBar*>(); }
  QVariant cell(std::size_t row, ReadingColumn column, int role) {
    return open->currentTable()->model()->index(static_cast<int>(row), static_cast<int>(column)).data(role);
  }
  /// The tens of the minutes are wrong by one: 80°53′00″ becomes 80°43′00″.
  std::string slipped() const {
    std::string text = typed;
    const std::size_t tens = text.find("°") + std::string("°").size();
    text[tens] = text[tens] == '5' ? '4' : static_cast<char>(text[tens] + 1);
    return text;
  }

  OpenWindow open;
  std::string typed;
};

TEST(Suspects, AreMarkedInTheTableWithMoreThanColour) {
  SuspectBench bench;
  const QString doubt =
      bench.cell(slippedRow, ReadingColumn::Vertical, ReadingsModel::SuspectRole).toString();
  EXPECT_THAT(doubt.toStdString(), HasSubstr("point 4, vertical"));
  for (const int role : {int{Qt::ToolTipRole}, int{Qt::AccessibleDescriptionRole}})
    EXPECT_TRUE(bench.cell(slippedRow, ReadingColumn::Vertical, role).toString().startsWith(doubt));
  EXPECT_TRUE(
      bench.cell(slippedRow, ReadingColumn::Horizontal, ReadingsModel::SuspectRole).toString().isEmpty());
  EXPECT_TRUE(
      bench.cell(slippedRow + 1, ReadingColumn::Vertical, ReadingsModel::SuspectRole).toString().isEmpty());
}

TEST(Suspects, AreLedToAndCorrectedByTheKeyboardInOneUndoStep) {
  SuspectBench bench;
  bench.open->findChild<QListWidget*>()->setFocus();
  QTest::keyClick(bench.open.window.get(), Qt::Key_F7);
  EXPECT_EQ(bench.open->currentTable()->currentIndex().row(), static_cast<int>(slippedRow));
  EXPECT_EQ(bench.open->currentTable()->currentIndex().column(), static_cast<int>(ReadingColumn::Vertical));
  EXPECT_TRUE(bench.open->currentTable()->hasFocus());
  ASSERT_TRUE(bench.bar().hasProposal());
  QTest::keyClick(bench.open.window.get(), Qt::Key_F8);
  bench.open.waitUntilIdle();
  EXPECT_EQ(shownAngle(bench.readings()[slippedRow].vertical, CircleUnit::Dms),
            shownAngle(bench.typed, CircleUnit::Dms));
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
  EXPECT_FALSE(bench.bar().isVisible()) << "nothing looks misread any more";
  bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_EQ(bench.readings()[slippedRow].vertical, bench.slipped());
  EXPECT_TRUE(bench.bar().isVisible());
}

TEST(Suspects, OfferTheReadingAndItsExclusionOneClickAway) {
  SuspectBench bench;
  const auto* use = bench.bar().findChild<QPushButton*>(QStringLiteral("use proposal"));
  ASSERT_TRUE(use->isVisible());
  EXPECT_THAT(use->text().toStdString(), HasSubstr(shownAngle(bench.typed, CircleUnit::Dms).toStdString()));
  QTest::mouseClick(bench.bar().findChild<QPushButton*>(QStringLiteral("exclude suspect")), Qt::LeftButton);
  bench.open.waitUntilIdle();
  EXPECT_TRUE(bench.readings()[slippedRow].excluded);
  EXPECT_EQ(bench.readings()[slippedRow].vertical, bench.slipped()) << "what was typed stays";
  EXPECT_FALSE(bench.bar().isVisible());
  EXPECT_EQ(bench.open->document().undoStack().count(), 1);
}

TEST(Suspects, AreReadInFullAtAnyWidth) {
  SuspectBench bench;
  for (const int width : {1280, 1024}) {
    bench.open->resize(width, 800);
    QCoreApplication::processEvents();
    for (const QLabel* label : bench.bar().findChildren<QLabel*>())
      EXPECT_TRUE(!label->wordWrap() || label->height() >= label->heightForWidth(label->width())) << width;
  }
}

TEST(Suspects, LeaveTheValueBesideTheirSignWhole) {
  SuspectBench bench;
  const ReadingsTable& table = *bench.open->currentTable();
  const auto shortened = [&](std::size_t row, ReadingColumn column) {
    const QModelIndex cell = table.model()->index(static_cast<int>(row), static_cast<int>(column));
    return table.sizeHintForIndex(cell).width() - table.columnWidth(cell.column());
  };
  for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
    bench.open->resize(size);
    QApplication::processEvents();
    EXPECT_LE(shortened(slippedRow, ReadingColumn::Vertical), 0) << size.width();
  }
  ReadingsEditor(bench.open->document(), 0).setCell({1, ReadingColumn::Horizontal}, "341°71'26.0\"");
  for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
    bench.open->resize(size);
    QApplication::processEvents();
    EXPECT_LE(shortened(1, ReadingColumn::Horizontal), 0) << "a tenth of a second, at " << size.width();
  }
}

TEST(Suspects, AreNotUsedOnceTheSessionHasChanged) {
  SuspectBench bench;
  ASSERT_TRUE(bench.bar().current());
  changeField(bench.open->document(), {.field = "title"}, "edited");
  EXPECT_FALSE(bench.bar().current()) << "the rows may have moved";
  bench.bar().useProposal();
  EXPECT_EQ(bench.readings()[slippedRow].vertical, bench.slipped());
  bench.open.waitUntilIdle();
  EXPECT_TRUE(bench.bar().current());
}

TEST(Suspects, AreNeverShownAgainstANewerSession) {
  SuspectBench bench;
  const auto* use = bench.bar().findChild<QPushButton*>(QStringLiteral("use proposal"));
  const auto shows = [&](const std::string& what) {
    const auto labels = bench.bar().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text().contains(qText(what)); });
  };
  ASSERT_TRUE(shows("point 4"));
  bool isFitted = false;
  QObject::connect(&bench.open->job(), &FitJob::evaluated, [&] { isFitted = true; });
  ReadingsEditor(bench.open->document(), 0).setCell({slippedRow, ReadingColumn::Vertical}, bench.typed);
  const auto showsNone = [&] { return !shows("point 4") && !use->isVisible() && !bench.bar().current(); };
  EXPECT_TRUE(showsNone()) << "from the edit on";
  ASSERT_TRUE(waitFor([&] { return isFitted; }));
  EXPECT_TRUE(showsNone() || !bench.bar().isVisible()) << "with the new fit";
  EXPECT_TRUE(
      bench.cell(slippedRow, ReadingColumn::Vertical, ReadingsModel::SuspectRole).toString().isEmpty());
  bench.open.waitUntilIdle();
  EXPECT_FALSE(bench.bar().isVisible());
  bench.open->undo();
  bench.open.waitUntilIdle();
  EXPECT_TRUE(use->isVisible());
}

TEST(Suspects, LeaveTheBarItsPlaceWhileTheyAreSought) {
  SuspectBench bench;
  const int height = bench.bar().height();
  changeField(bench.open->document(), {.field = "title"}, "edited");
  QCoreApplication::sendPostedEvents();
  EXPECT_TRUE(bench.bar().isVisible());
  bench.open->findChild<FindingsPanel*>()->parentWidget()->layout()->activate();
  EXPECT_EQ(bench.bar().height(), height) << "the table above must not jump at every edit";
}

TEST(Suspects, AreGoneWithASoundSession) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("clean-session.alidade"))));
  open.waitUntilIdle();
  EXPECT_FALSE(open->findChild<SuspectBar*>()->isVisible());
}

/// Built member by member: g++ 12 reports nested designated initialisers as uninitialised.
CellChange change(std::size_t position, std::size_t reading, const char* field, const char* text) {
  CellChange made;
  made.where.position = position;
  made.where.reading = reading;
  made.where.field = field;
  made.text = text;
  return made;
}

TEST(ApplyChanges, IsOneStepAcrossRowsAndPositions) {
  SessionDocument document;
  for (const std::size_t position : {0, 1})
    ReadingsEditor(document, position)
        .paste(parseBlock(QStringLiteral("1 0 0;2 0 0\n3 0 0;4 0 0\n5 0 0;6 0 0")), 0,
               {ReadingColumn::Horizontal, ReadingColumn::Vertical});
  document.undoStack().clear();
  const Session before = document.session();
  applyChanges(document,
               {change(0, 0, "horizontal", "7 0 0"), change(0, 2, "face", "2"),
                change(1, 1, "vertical", "8 0 0"), change(1, 9, "vertical", "9 0 0")},
               QStringLiteral("Correct"));
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.session().positions[0].readings[0].horizontal, "7 0 0");
  EXPECT_EQ(document.session().positions[0].readings[1].horizontal, "3 0 0");
  EXPECT_EQ(document.session().positions[0].readings[2].face, "2");
  EXPECT_EQ(document.session().positions[1].readings[1].vertical, "8 0 0");
  document.undoStack().undo();
  EXPECT_EQ(document.session(), before);
}

}  // namespace
}  // namespace alidade::ui
