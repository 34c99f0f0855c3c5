#include "ui/instrument/instrument_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLineEdit>
#include <QMenuBar>
#include <QProcess>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "tests/ui/support.h"
#include "ui/instrument/check_chart.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/check_rows_table.h"
#include "ui/main_window.h"
#include "ui/panels/gap/gap_headline.h"
#include "ui/panels/parts/data_table.h"
#include "ui/window/side_windows.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;

const QString sample = QStringLiteral("instrument-check.gsi");

struct CheckBench {
  CheckBench() { dialog.show(); }

  void waitUntilIdle() {
    ASSERT_TRUE(waitFor([this] { return !dialog.job().isAtWork(); }));
  }
  void open(const QString& path) {
    dialogs.importPath = path;
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("open check files")), Qt::LeftButton);
    waitUntilIdle();
  }
  QString cell(int row, int column) {
    return dialog.findChild<DataTable*>()->model()->index(row, column).data().toString();
  }
  int rows() { return dialog.findChild<DataTable*>()->model()->rowCount(); }
  std::string said() { return dialog.said().toStdString(); }

  ScriptedDialogs dialogs;
  InstrumentDialog dialog{dialogs};
};

TEST(InstrumentDialog, ShowsWhatAFileOfTwoStationsSays) {
  CheckBench bench;
  EXPECT_THAT(bench.said(), HasSubstr("Allow half an hour"));
  bench.open(samplePath(sample));
  ASSERT_EQ(bench.rows(), 3);
  EXPECT_EQ(bench.cell(0, 0), QStringLiteral("P1"));
  EXPECT_EQ(bench.cell(0, 1), QStringLiteral("4 × 5"));
  EXPECT_TRUE(bench.cell(2, 2).endsWith(QStringLiteral("(24)"))) << bench.cell(2, 2).toStdString();
  EXPECT_THAT(bench.said(), HasSubstr("is proportional to 1/D"));
  EXPECT_EQ(bench.dialog.chart().plot()->markers().marks().size(), 16U) << "c and index of eight rounds";
  bench.dialog.chart().setView(CheckPlot::View::Residuals);
  EXPECT_EQ(bench.dialog.chart().plot()->markers().marks().size(), 80U);
  bench.dialog.chart().setView(CheckPlot::View::Distance);
  EXPECT_EQ(bench.dialog.chart().plot()->markers().marks().size(), 10U);
  EXPECT_FALSE(bench.dialog.chart()
                   .plot()
                   ->describe(bench.dialog.chart().plot()->markers().marks().front())
                   .isEmpty());
}

TEST(InstrumentDialog, JoinsDegreesMinutesAndSecondsThatArePasted) {
  CheckBench bench;
  QApplication::clipboard()->setText(
      QStringLiteral("target\thz deg\thz min\thz sec\tv deg\tv min\tv sec\n"
                     "A\t10\t20\t30\t88\t1\t2\n"));
  bench.dialog.input().table().paste();
  const CheckRowsModel& rows = bench.dialog.input().table().rows();
  EXPECT_EQ(rows.index(0, 4).data().toString(), QStringLiteral("10 20 30"));
  EXPECT_EQ(rows.index(0, 5).data().toString(), QStringLiteral("88 01 02"));
}

TEST(InstrumentDialog, RefusesAPasteOfTwoColumnsForOneCircle) {
  CheckBench bench;
  QApplication::clipboard()->setText(QStringLiteral("target\tHz\tHz\tV\nA\t10 20 30\t11 20 30\t88 1 2\n"));
  bench.dialog.input().table().paste();
  EXPECT_TRUE(bench.dialog.input().table().rows().isBlank());
  ASSERT_EQ(bench.dialogs.problems.size(), 1);
  EXPECT_THAT(bench.dialogs.problems[0].toStdString(), HasSubstr("not pasted"));
}

TEST(InstrumentDialog, ChecksRowsAsTheyArePasted) {
  CheckBench bench;
  QApplication::clipboard()->setText(
      QStringLiteral("target\tHz [gon]\tV [gon]\n"
                     "A\t10.0010\t98\nB\t60.0000\t99\nB\t260.0010\t301.0010\nA\t210.0020\t302.0020\n"
                     "A\t10.0020\t98.0010\nB\t60.0020\t99\nB\t260.0030\t301.0020\nA\t210.0020\t302.0020\n"));
  bench.dialog.input().table().paste();
  bench.waitUntilIdle();
  ASSERT_EQ(bench.rows(), 1);
  EXPECT_EQ(bench.cell(0, 1), QStringLiteral("2 × 2"));
  EXPECT_TRUE(bench.cell(0, 2).endsWith(QStringLiteral("(1)")));
  CheckRowsModel& rows = bench.dialog.input().table().rows();
  EXPECT_EQ(rows.rowCount(), 9) << "and the empty one";
  rows.setData(rows.index(2, 5), QStringLiteral("88°71'"), Qt::EditRole);
  bench.waitUntilIdle();
  EXPECT_EQ(bench.rows(), 0);
  EXPECT_THAT(bench.said(), HasSubstr("line 3: "));
  rows.setData(rows.index(2, 5), QStringLiteral("301.0010gon"), Qt::EditRole);
  bench.waitUntilIdle();
  EXPECT_EQ(bench.rows(), 1);
}

TEST(InstrumentDialog, WaitsForTheRowThatIsBeingTyped) {
  CheckBench bench;
  CheckRowsModel& rows = bench.dialog.input().table().rows();
  rows.setData(rows.index(0, 2), QStringLiteral("A"), Qt::EditRole);
  bench.waitUntilIdle();
  EXPECT_THAT(bench.said(), HasSubstr("Allow half an hour"));
  rows.setData(rows.index(0, 4), QStringLiteral("10°"), Qt::EditRole);
  rows.setData(rows.index(0, 5), QStringLiteral("88°"), Qt::EditRole);
  bench.waitUntilIdle();
  EXPECT_EQ(rows.rowCount(), 2);
  EXPECT_THAT(bench.said(), HasSubstr("There is no complete round"));
}

TEST(InstrumentDialog, TestsAgainstWhatIsStated) {
  CheckBench bench;
  bench.open(samplePath(sample));
  bench.dialog.findChild<QDoubleSpinBox*>()->setValue(0.2);
  bench.waitUntilIdle();
  EXPECT_THAT(bench.said(), HasSubstr("is significantly larger than the stated 0.2″"));
}

TEST(InstrumentDialog, WritesWhatTheConsolePrints) {
  CheckBench bench;
  bench.open(samplePath(sample));
  const QTemporaryDir folder;
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("check.json"));
  ASSERT_TRUE(bench.dialog.exportJson());
  EXPECT_TRUE(bench.dialogs.exportSuggested.endsWith(QStringLiteral("instrument-check-check.json")));
  QFile file(bench.dialogs.exportPath);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const auto json = nlohmann::ordered_json::parse(file.readAll().toStdString());
  EXPECT_EQ(json["pooled"]["dof_direction"], 24);
  bench.dialogs.exportPath = samplePath(sample);
  EXPECT_FALSE(bench.dialog.exportCsv()) << "over what was read";
  EXPECT_EQ(bench.dialogs.problems.size(), 1);
}

void type(CheckBench& bench, const char* field, const char* text) {
  auto* line = bench.dialog.findChild<QLineEdit*>(QString::fromLatin1(field));
  line->setText(QString::fromLatin1(text));
  emit line->editingFinished();
  bench.waitUntilIdle();
}

TEST(InstrumentDialog, HasItsVerdictAtTheTop) {
  CheckBench bench;
  const auto verdict = [&] {
    std::string text;
    for (const QLabel* label : bench.dialog.findChild<GapHeadline*>()->findChildren<QLabel*>())
      text += label->text().toStdString() + "\n";
    return text;
  };
  EXPECT_TRUE(bench.dialog.findChild<GapHeadline*>()->isHidden());
  bench.open(samplePath(sample));
  EXPECT_FALSE(bench.dialog.findChild<GapHeadline*>()->isHidden());
  EXPECT_THAT(verdict(), HasSubstr("Not judged: "));
  for (QDoubleSpinBox* box : bench.dialog.findChildren<QDoubleSpinBox*>()) box->setValue(1);
  bench.waitUntilIdle();
  EXPECT_THAT(verdict(), HasSubstr("Passed: "));
  for (QDoubleSpinBox* box : bench.dialog.findChildren<QDoubleSpinBox*>()) box->setValue(0.3);
  bench.waitUntilIdle();
  EXPECT_THAT(verdict(), HasSubstr("Failed: "));
}

TEST(InstrumentDialog, StatesTypedInstrumentAndDaysEverywhere) {
  CheckBench bench;
  bench.open(samplePath(sample));
  EXPECT_EQ(bench.dialog.findChild<QLineEdit*>(QStringLiteral("check date"))->placeholderText(),
            QStringLiteral("2026-03-14"));
  type(bench, "check name", "TM 5100");
  type(bench, "check due", "2026-01-01");
  EXPECT_THAT(bench.said(), HasSubstr("not after"));
  type(bench, "check due", "2027-03-14");
  const QTemporaryDir folder;
  const auto written = [&](const char* name, bool (InstrumentDialog::*write)()) {
    bench.dialogs.exportPath = folder.filePath(QString::fromLatin1(name));
    EXPECT_TRUE((bench.dialog.*write)()) << name;
    QFile file(bench.dialogs.exportPath);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll().toStdString();
  };
  const auto json = nlohmann::ordered_json::parse(written("c.json", &InstrumentDialog::exportJson));
  EXPECT_EQ(json["instrument"]["name"], "TM 5100");
  EXPECT_EQ(json["next_check_due"], "2027-03-14");
  EXPECT_THAT(written("c.csv", &InstrumentDialog::exportCsv), HasSubstr(",TM 5100,123456,2026-03-14\n"));
  const auto record =
      nlohmann::ordered_json::parse(written("r.alidade-instrument", &InstrumentDialog::saveRecord));
  EXPECT_EQ(record["next_check_due"], "2027-03-14");
  const std::string pdf = written("c.pdf", &InstrumentDialog::exportPdf);
  EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
  QProcess text;
  text.start(QStringLiteral("pdftotext"), {bench.dialogs.exportPath, QStringLiteral("-")});
  ASSERT_TRUE(text.waitForFinished());
  const std::string pages = text.readAllStandardOutput().toStdString();
  for (const char* words : {"Not judged: ", "TM 5100", "123456", "2026-03-14", "2027-03-14", "by target"})
    EXPECT_THAT(pages, HasSubstr(words));
}

TEST(InstrumentDialog, SavesWhatSessionsMayTake) {
  CheckBench bench;
  bench.open(samplePath(sample));
  const QTemporaryDir folder;
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("t2.alidade-instrument"));
  ASSERT_TRUE(bench.dialog.saveRecord());
  EXPECT_TRUE(
      bench.dialogs.exportSuggested.endsWith(QStringLiteral("/123456-2026-03-14.alidade-instrument")));
  QFile file(bench.dialogs.exportPath);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const auto record = nlohmann::ordered_json::parse(file.readAll().toStdString());
  EXPECT_EQ(record["format"], "alidade-instrument");
  EXPECT_EQ(record["serial"], "123456");
  EXPECT_EQ(record["date"], "2026-03-14");
  EXPECT_EQ(record["known"].size(), 3U);
}

TEST(InstrumentDialog, TellsWhatCannotBeRead) {
  CheckBench bench;
  bench.open(samplePath(QStringLiteral("paper-table-1.alidade")));
  EXPECT_EQ(bench.dialogs.problems.size(), 1);
  EXPECT_EQ(bench.dialog.input().paths(), QStringList());
}

TEST(InstrumentDialog, OpensFromTheMenuAndNamesEveryControl) {
  OpenWindow open;
  open->sideWindows().showInstrumentCheck();
  auto* dialog = open->findChild<InstrumentDialog*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  for (QTabWidget* tabs : dialog->findChildren<QTabWidget*>())
    for (int page = 0; page < tabs->count(); ++page) {
      tabs->setCurrentIndex(page);
      QCoreApplication::processEvents();
      for (QWidget* widget : dialog->findChildren<QWidget*>()) {
        if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
        QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(widget);
        EXPECT_TRUE(accessible && !accessible->text(QAccessible::Name).isEmpty())
            << widget->metaObject()->className() << " " << widget->objectName().toStdString();
      }
    }
}

}  // namespace
}  // namespace alidade::ui
