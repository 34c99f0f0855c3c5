#include "ui/panels/readings/readings_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QTest>

#include "core/evaluation/evaluation.h"
#include "tests/ui/support.h"
#include "ui/document/session_document.h"

namespace alidade::ui {
namespace {

using testing::ElementsAre;

/// The table of the first position, shown, with its cell `horizontal` of the first row current.
struct Bench {
  explicit Bench(const ReadingBlock& readings = {}) : table(document, 0) {
    table.resize(700, 400);
    table.show();
    QApplication::setActiveWindow(&table);
    ReadingsEditor(document, 0).paste(readings, 0, {ReadingColumn::Horizontal, ReadingColumn::Vertical});
    document.undoStack().clear();
    table.selectCell(0, ReadingColumn::Horizontal);
    table.setFocus();
  }

  const std::vector<Reading>& readings() const { return document.session().positions[0].readings; }
  QString shown(int row, ReadingColumn column) const {
    return table.model()->index(row, static_cast<int>(column)).data().toString();
  }
  void select(int top, ReadingColumn left, int bottom, ReadingColumn right) {
    table.selectCell(top, left);
    table.selectionModel()->select({table.model()->index(top, static_cast<int>(left)),
                                    table.model()->index(bottom, static_cast<int>(right))},
                                   QItemSelectionModel::ClearAndSelect);
  }

  SessionDocument document;
  ReadingsTable table;
};

ReadingBlock threeReadings() {
  return parseBlock(QStringLiteral("341 52 24;88 16 49\n341 26 01;86 41 24\n340 44 00;85 11 45"));
}

TEST(ReadingsTable, TakesAPositionTypedOnTheNumberPad) {
  Bench bench;
  typeInto(bench.table, QStringLiteral("3415224"));
  typeInto(bench.table, QStringLiteral("881649"));
  typeInto(bench.table, QStringLiteral("3412601"), Qt::Key_Enter);
  typeInto(bench.table, QStringLiteral("864124"), Qt::Key_Tab);
  ASSERT_EQ(bench.readings().size(), 2u);
  EXPECT_EQ(bench.readings()[0].point, "1");
  EXPECT_EQ(bench.readings()[0].horizontal, "3415224");
  EXPECT_EQ(bench.readings()[0].vertical, "881649");
  EXPECT_EQ(bench.readings()[1].point, "2");
  EXPECT_EQ(bench.readings()[1].vertical, "864124");
  EXPECT_EQ(bench.shown(0, ReadingColumn::Horizontal), QStringLiteral("341°52′24″"));
  EXPECT_EQ(bench.table.currentIndex().row(), 2);
  EXPECT_EQ(bench.table.currentIndex().column(), static_cast<int>(ReadingColumn::Horizontal));
}

// For a return run in face 2, face and round are typed once.
TEST(ReadingsTable, GoesOnInTheFaceAndRoundOfTheRowAbove) {
  Bench bench(threeReadings());
  ReadingsEditor editor(bench.document, 0);
  editor.setCell({2, ReadingColumn::Face}, "2");
  editor.setCell({2, ReadingColumn::Round}, "3");
  bench.table.selectCell(3, ReadingColumn::Horizontal);
  typeInto(bench.table, QStringLiteral("3400000"));
  ASSERT_EQ(bench.readings().size(), 4u);
  EXPECT_EQ(bench.readings()[3].face, "2");
  EXPECT_EQ(bench.readings()[3].round, "3");
  EXPECT_EQ(bench.readings()[3].point, "4");
  EXPECT_EQ(bench.readings()[3].horizontal, "3400000");
}

TEST(ReadingsTable, EditsWhatWasTypedAndTakesItBackOnEscape) {
  Bench bench;
  typeInto(bench.table, QStringLiteral("3415224"));
  bench.table.selectCell(0, ReadingColumn::Horizontal);
  QTest::keyClick(&bench.table, Qt::Key_F2);
  auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_TRUE(editor);
  EXPECT_EQ(editor->text(), QStringLiteral("3415224"));
  typeInto(*editor, QStringLiteral("9"), Qt::Key_Escape);
  EXPECT_EQ(bench.readings()[0].horizontal, "3415224");
  EXPECT_EQ(bench.document.undoStack().count(), 1);
}

TEST(ReadingsTable, KeepsAndMarksAWrongAngle) {
  Bench bench(threeReadings());
  typeInto(bench.table, QStringLiteral("341 72 24"));
  EXPECT_EQ(bench.readings()[0].horizontal, "341 72 24");
  EXPECT_EQ(bench.shown(0, ReadingColumn::Horizontal), QStringLiteral("341 72 24"));
  const QModelIndex cell = bench.table.model()->index(0, static_cast<int>(ReadingColumn::Horizontal));
  EXPECT_THAT(cell.data(ReadingsModel::ProblemRole).toString().toStdString(), testing::HasSubstr("72"));
  EXPECT_THAT(cell.data(Qt::ToolTipRole).toString().toStdString(),
              testing::StartsWith(cell.data(ReadingsModel::ProblemRole).toString().toStdString() +
                                  "\nFirst entered"));
  bench.document.undoStack().undo();
  EXPECT_EQ(bench.readings()[0].horizontal, "341 52 24");
  EXPECT_TRUE(cell.data(ReadingsModel::ProblemRole).toString().isEmpty());
}

TEST(ReadingsTable, MarksABlankRowAsIncompleteNotAsWrong) {
  Bench bench(threeReadings());
  bench.table.selectCell(1, ReadingColumn::Horizontal);
  bench.table.insertAbove();
  ASSERT_EQ(bench.readings().size(), 4u);
  const QModelIndex cell = bench.table.model()->index(1, static_cast<int>(ReadingColumn::Vertical));
  EXPECT_TRUE(cell.data(ReadingsModel::IncompleteRole).toBool());
  EXPECT_TRUE(cell.data(ReadingsModel::ProblemRole).toString().isEmpty());
}

TEST(ReadingsTable, PastesTwoColumnsOfReadingsAndNumbersThem) {
  Bench bench;
  QString text;
  for (int i = 0; i < 17; ++i) text += QStringLiteral("34%1 00 %2\t8%1 00 %2\r\n").arg(i % 10).arg(10 + i);
  QApplication::clipboard()->setText(text);
  QTest::keyClick(&bench.table, Qt::Key_V, Qt::ControlModifier);
  ASSERT_EQ(bench.readings().size(), 17u);
  EXPECT_EQ(bench.readings()[16].point, "17");
  EXPECT_EQ(bench.readings()[16].horizontal, "346 00 26");
  EXPECT_EQ(bench.readings()[16].vertical, "86 00 26");
  EXPECT_EQ(bench.document.undoStack().undoText(), QStringLiteral("Paste 17 readings"));
  bench.document.undoStack().undo();
  EXPECT_TRUE(bench.readings().empty());
}

TEST(ReadingsTable, PastesPointsWithTheirReadings) {
  Bench bench;
  bench.table.selectCell(0, ReadingColumn::Point);
  QApplication::clipboard()->setText(QStringLiteral("7;341 52 24;88 16 49\n9;\"341°26'01\"\"\";86 41 24\n"));
  bench.table.paste();
  ASSERT_EQ(bench.readings().size(), 2u);
  EXPECT_EQ(bench.readings()[0].point, "7");
  EXPECT_EQ(bench.readings()[1].point, "9");
  EXPECT_EQ(bench.readings()[1].horizontal, "341°26'01\"");
  EXPECT_EQ(bench.readings()[1].vertical, "86 41 24");
}

// A spreadsheet separates cells by semicolons; in a cell of this program they are text.
TEST(ReadingsTable, PastesItsOwnCellsWithSemicolonsAndQuotationMarks) {
  for (const char* note : {"sun; retaken", "\"cloud\"", "a;\"b\";c"}) {
    Bench bench(threeReadings());
    QAbstractItemModel& model = *bench.table.model();
    model.setData(model.index(0, static_cast<int>(ReadingColumn::Note)), QString::fromUtf8(note));
    bench.select(0, ReadingColumn::Note, 0, ReadingColumn::Note);
    bench.table.cut();
    EXPECT_EQ(bench.readings()[0].note, "");
    bench.table.selectCell(1, ReadingColumn::Note);
    bench.table.paste();
    EXPECT_EQ(bench.readings()[1].note, note);
  }
}

TEST(ReadingsTable, CopiesWhatWasTypedAndPastesItBackUnchanged) {
  Bench bench(threeReadings());
  bench.select(0, ReadingColumn::Used, 2, ReadingColumn::Note);
  bench.table.copy();
  EXPECT_EQ(QApplication::clipboard()->text().section(QLatin1Char('\n'), 0, 0),
            QStringLiteral("1\t1\t341 52 24\t88 16 49\t"));
  const std::vector<Reading> before = bench.readings();
  bench.table.selectAll();
  bench.table.clearCells();
  EXPECT_EQ(bench.readings()[2].vertical, "");
  bench.table.selectCell(0, ReadingColumn::Used);
  bench.table.paste();
  EXPECT_EQ(bench.readings(), before);
}

TEST(ReadingsTable, PastesByTheNamesInTheFirstRow) {
  Bench bench;
  QString remark;
  QObject::connect(&bench.table, &ReadingsTable::remark, [&](const QString& text) { remark = text; });
  bench.table.selectCell(0, ReadingColumn::Vertical);
  QApplication::clipboard()->setText(
      QStringLiteral("Temp\tV [gon]\tPoint No\tHz\tskip\n20.5\t98,0811\t7\t341 52 24\t\n"
                     "20.6\t97,54\t9\t341 26 01\tyes\n"));
  bench.table.paste();
  ASSERT_EQ(bench.readings().size(), 2u);
  EXPECT_EQ(bench.readings()[0].point, "7");
  EXPECT_EQ(bench.readings()[0].horizontal, "341 52 24");
  EXPECT_EQ(bench.readings()[0].vertical, "98,0811gon");
  EXPECT_FALSE(bench.readings()[0].excluded);
  EXPECT_TRUE(bench.readings()[1].excluded);
  EXPECT_THAT(remark.toStdString(), testing::HasSubstr("Temp"));
  bench.document.undoStack().undo();
  EXPECT_TRUE(bench.readings().empty());
}

TEST(ReadingsTable, PastesTextThatIsNoNameAsItStands) {
  Bench bench(threeReadings());
  bench.table.selectCell(0, ReadingColumn::Note);
  QApplication::clipboard()->setText(QStringLiteral("note"));
  bench.table.paste();
  EXPECT_EQ(bench.readings()[0].note, "note") << "a single cell";
  QApplication::clipboard()->setText(QStringLiteral("wind\nsun"));
  bench.table.paste();
  EXPECT_EQ(bench.readings()[0].note, "wind");
  EXPECT_EQ(bench.readings()[1].note, "sun");
}

TEST(ReadingsTable, SaysWhichPastedColumnsFoundNoRoom) {
  Bench bench(threeReadings());
  QString remark;
  QObject::connect(&bench.table, &ReadingsTable::remark, [&](const QString& text) { remark = text; });
  bench.table.selectCell(0, ReadingColumn::Vertical);
  QApplication::clipboard()->setText(QStringLiteral("88 00 00\tnote\tmore\tmost"));
  bench.table.paste();
  EXPECT_EQ(bench.readings()[0].note, "note");
  EXPECT_THAT(remark.toStdString(), testing::HasSubstr("2"));
}

/// Widths of a column of angles in a narrow and in a wide table; the wide one is kept.
struct AngleWidths {
  explicit AngleWidths(ReadingsTable& table) : m_table(table) {
    m_table.resize(200, 400);
    least = now();
    m_table.resize(1200, 400);
    most = now();
  }

  int now() const { return m_table.columnWidth(static_cast<int>(ReadingColumn::Horizontal)); }

  int least = 0, most = 0;

 private:
  ReadingsTable& m_table;
};

TEST(ReadingsTable, GivesAnglesTheRoomThereIsUntilAColumnIsDrawnByHand) {
  Bench bench(threeReadings());
  const AngleWidths widths(bench.table);
  EXPECT_GT(widths.most, widths.least);
  bench.table.resize(200, 400);
  EXPECT_EQ(widths.now(), widths.least) << "as often as the table changes";
  bench.table.resize(1200, 400);
  EXPECT_EQ(widths.now(), widths.most);
  bench.table.setColumnWidth(static_cast<int>(ReadingColumn::Horizontal), widths.most + 7);
  bench.table.resize(200, 400);
  EXPECT_EQ(widths.now(), widths.most + 7) << "what was drawn by hand stays";
}

TEST(ReadingsTable, ShowsAllColumnsWithoutScrollingWhereTheirAnglesFit) {
  Bench bench(threeReadings());
  const AngleWidths widths(bench.table);
  int between = 0;
  for (int size = 300; size < 1000; size += 10) {
    bench.table.resize(size, 400);
    if (widths.now() == widths.least || widths.now() == widths.most) continue;
    ++between;
    const int last = readingColumnCount - 1;
    const int left = bench.table.viewport()->width() - bench.table.columnViewportPosition(last);
    EXPECT_NEAR(left, bench.table.fontMetrics().horizontalAdvance(QStringLiteral("Note")) + 12, 2)
        << size << ": notes keep the width of their heading";
  }
  EXPECT_GT(between, 0);
}

TEST(ReadingsTable, ExcludesAndUsesTheSelectedRowsInOneStep) {
  Bench bench(threeReadings());
  bench.select(0, ReadingColumn::Horizontal, 1, ReadingColumn::Vertical);
  QTest::keyClick(&bench.table, Qt::Key_Space);
  EXPECT_TRUE(bench.readings()[0].excluded);
  EXPECT_TRUE(bench.readings()[1].excluded);
  EXPECT_FALSE(bench.readings()[2].excluded);
  EXPECT_EQ(bench.document.undoStack().count(), 1);
  QTest::keyClick(&bench.table, Qt::Key_Space);
  EXPECT_FALSE(bench.readings()[1].excluded);
}

TEST(ReadingsTable, DeletesRowsThatAreNotNeighboursInOneStep) {
  Bench bench(threeReadings());
  const std::vector<Reading> before = bench.readings();
  bench.select(0, ReadingColumn::Horizontal, 0, ReadingColumn::Horizontal);
  bench.table.selectionModel()->select(
      bench.table.model()->index(2, static_cast<int>(ReadingColumn::Vertical)), QItemSelectionModel::Select);
  QTest::keyClick(&bench.table, Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_THAT(bench.readings(), ElementsAre(before[1]));
  bench.document.undoStack().undo();
  EXPECT_EQ(bench.readings(), before);
}

TEST(ReadingsTable, ClearsCellsWithDeleteAndCutsToTheClipboard) {
  Bench bench(threeReadings());
  bench.select(0, ReadingColumn::Vertical, 1, ReadingColumn::Vertical);
  QTest::keyClick(&bench.table, Qt::Key_X, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("88 16 49\n86 41 24"));
  EXPECT_EQ(bench.readings()[1].vertical, "");
  bench.select(2, ReadingColumn::Horizontal, 2, ReadingColumn::Horizontal);
  QTest::keyClick(&bench.table, Qt::Key_Delete);
  EXPECT_EQ(bench.readings()[2].horizontal, "");
  EXPECT_EQ(bench.readings().size(), 3u);
}

TEST(ReadingsTable, ShowsColumnsThatTheSessionUses) {
  Bench bench(threeReadings());
  EXPECT_TRUE(bench.table.isColumnHidden(static_cast<int>(ReadingColumn::Face)));
  ReadingsEditor(bench.document, 0).setCell({1, ReadingColumn::Face}, "2");
  EXPECT_FALSE(bench.table.isColumnHidden(static_cast<int>(ReadingColumn::Face)));
  EXPECT_TRUE(bench.table.isColumnHidden(static_cast<int>(ReadingColumn::Round)));
}

TEST(ReadingsTable, LeavesTheTableByTabFromTheEmptyRow) {
  Bench bench(threeReadings());
  bench.table.selectCell(3, ReadingColumn::Vertical);
  QTest::keyClick(&bench.table, Qt::Key_Tab);
  EXPECT_EQ(bench.table.currentIndex().row(), 3);
  EXPECT_EQ(bench.readings().size(), 3u);
}

// The first reading of Table I: 25.19″ with 2″ stated, s0 = 6.912, r = 0.6117.
TEST(ReadingsModel, TellsTheStandardisedResidual) {
  SessionDocument document;
  document.startWith(paperSession());
  ReadingsModel model(document, 0);
  const auto tip = [&](int row) {
    return model.index(row, static_cast<int>(ReadingColumn::HorizontalResidual))
        .data(Qt::ToolTipRole)
        .toString();
  };
  EXPECT_TRUE(tip(0).isEmpty()) << "nothing is fitted";
  model.setEvaluation(std::make_shared<const Evaluation>(evaluateFit(paperSession())));
  EXPECT_EQ(tip(0), QStringLiteral("Standardised residual w = v/(s0 σ √r): +2.33"));
}

TEST(ReadingsModel, SaysWhereNoOtherReadingChecksOne) {
  Session session = paperSession();
  auto& readings = session.positions[0].readings;
  readings = {readings[0], readings[8], readings[16]};
  SessionDocument document;
  document.startWith(session);
  ReadingsModel model(document, 0);
  model.setEvaluation(std::make_shared<const Evaluation>(evaluateFit(session)));
  EXPECT_EQ(model.index(0, static_cast<int>(ReadingColumn::HorizontalResidual)).data(Qt::ToolTipRole),
            QStringLiteral("No other reading checks this one: its residual cannot show an error"));
}

TEST(ReadingsModel, TellsOnlyOfCellsThatSaySomethingElse) {
  SessionDocument document;
  document.startWith(paperSession());
  ReadingsModel model(document, 0);
  QStringList reported;
  QObject::connect(&model, &QAbstractItemModel::dataChanged,
                   [&](const QModelIndex& first, const QModelIndex& last) {
                     reported.append(QStringLiteral("%1 to %2").arg(first.column()).arg(last.column()));
                   });
  Evaluation evaluation = evaluateFit(paperSession());
  const auto show = [&] { model.setEvaluation(std::make_shared<const Evaluation>(evaluation)); };
  show();
  const auto columns = [](ReadingColumn first, ReadingColumn last) {
    return QStringLiteral("%1 to %2").arg(static_cast<int>(first)).arg(static_cast<int>(last));
  };
  EXPECT_EQ(reported,
            QStringList{columns(ReadingColumn::HorizontalResidual, ReadingColumn::VerticalResidual)});
  show();
  EXPECT_EQ(reported.size(), 1);
  evaluation.examined.problems.push_back(
      {.what = "is odd", .where = {.position = 0, .reading = 2, .field = "vertical"}});
  show();
  EXPECT_EQ(reported.last(), columns(allReadingColumns().front().column, allReadingColumns().back().column))
      << "a problem marks its row";
}

}  // namespace
}  // namespace alidade::ui
