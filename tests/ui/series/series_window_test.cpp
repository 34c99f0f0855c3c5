#include "ui/series/series_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "core/series/history/history_sentences.h"
#include "core/session/session_file.h"
#include "core/statement/headline.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/series/diagnosis_panel.h"
#include "ui/series/history_chart.h"
#include "ui/series/history_panel.h"
#include "ui/text/visible_text.h"
#include "ui/window/side_windows.h"

// Tools › Series…: the sessions of a device together.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

constexpr int verdict = 5, condition = 6, trouble = 7;

struct SeriesBench {
  SeriesBench() {
    window.show();
    dialogs.seriesFolder = samplePath(QStringLiteral("history"));
  }

  void waitUntilIdle() {
    ASSERT_TRUE(waitFor([this] { return !window.job().isAtWork() && !window.diagnosisJob().isAtWork(); }));
  }
  void addYear() {
    window.addFolder();
    waitUntilIdle();
  }
  QString cell(int row, int column) { return window.table()->item(row, column)->text(); }
  std::string text(const char* name) {
    return window.findChild<QLabel*>(QString::fromLatin1(name))->text().toStdString();
  }

  ScriptedDialogs dialogs;
  SeriesWindow window{dialogs};
};

TEST(SeriesWindow, TellsTheHistoryOfAFolder) {
  SeriesBench bench;
  bench.addYear();
  ASSERT_EQ(bench.window.table()->rowCount(), 12);
  EXPECT_EQ(bench.cell(0, 0), QStringLiteral("2025-01-04"));
  EXPECT_EQ(bench.cell(11, 0), QStringLiteral("2025-12-15"));
  EXPECT_EQ(bench.cell(0, 2), QStringLiteral("T-1138"));
  EXPECT_EQ(bench.cell(0, 3), QStringLiteral("G-07"));
  EXPECT_THAT(bench.text("history says"), HasSubstr("From 2025-08-11 on"));
  const HistoryChart* chart = bench.window.findChild<HistoryChart*>();
  EXPECT_EQ(chart->plot()->markers().marks().size(), 12U);
  EXPECT_THAT(chart->accessibleDescription().toStdString(), HasSubstr("in steps"));
  expectAllVisible(bench.window, QStringLiteral("with a series"));
}

TEST(SeriesWindow, WatchesTheSessionsAfterItsBaseline) {
  SeriesBench bench;
  bench.addYear();
  auto* baseline = bench.window.history()->findChild<QSpinBox*>();
  EXPECT_EQ(baseline->text(), QStringLiteral("all sessions"));
  EXPECT_EQ(baseline->maximum(), 12);
  baseline->setValue(6);
  EXPECT_THAT(bench.text("history says"), HasSubstr("Baseline: 6 values"));
  const HistoryChart* chart = bench.window.findChild<HistoryChart*>();
  EXPECT_EQ(chart->plot()->history().chart.baseline, 6U);
  EXPECT_THAT(chart->numbers(), HasSubstr("expanded_uncertainty_mm"));
}

TEST(SeriesWindow, KeepsASeriesAsAFile) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("a b.alidade-series"));
  {
    SeriesBench bench;
    EXPECT_FALSE(bench.window.saveSeries());
    bench.addYear();
    bench.window.history()->setBaseline(4);
    bench.dialogs.exportPath = path;
    EXPECT_TRUE(bench.window.saveSeries());
    bench.dialogs.exportPath = samplePath(QStringLiteral("history/2025-01-04.alidade"));
    EXPECT_FALSE(bench.window.saveSeries()) << "never over a session";
  }
  SeriesBench bench;
  bench.window.add({path});
  bench.waitUntilIdle();
  EXPECT_EQ(bench.window.table()->rowCount(), 12);
  EXPECT_EQ(bench.window.history()->baseline(), 4);
  EXPECT_EQ(bench.window.history()->device()->quantities.front().history.chart.baseline, 4U);
}

TEST(SeriesWindow, TellsWhatTheSessionsShare) {
  SeriesBench bench;
  bench.window.add({samplePath(QStringLiteral("series"))});
  bench.waitUntilIdle();
  DiagnosisPanel& panel = *bench.window.diagnosis();
  ASSERT_GE(panel.causes()->model()->rowCount(), 1);
  ASSERT_EQ(panel.sessions()->model()->rowCount(), bench.window.table()->rowCount());
  const QSignalSpy wanted(&bench.window, &SeriesWindow::sessionWanted);
  bench.window.pages()->setCurrentWidget(&panel);
  emit panel.sessions()->rowActivated(2);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(QFile::exists(wanted.first().first().toString()));
}

TEST(SeriesWindow, ShowsTheQuantityThatIsChosen) {
  SeriesBench bench;
  bench.addYear();
  auto* quantities = bench.window.findChildren<QComboBox*>().at(1);
  quantities->setCurrentIndex(quantities->findData(QStringLiteral("radius_0")));
  emit quantities->activated(quantities->currentIndex());
  EXPECT_THAT(bench.text("history says"), HasSubstr("the values agree within their uncertainties"));
}

TEST(SeriesWindow, NamesACauseAsAPersonDoes) {
  EXPECT_EQ(quantityName("underestimated_noise: ratio"), "noise larger than stated: ratio");
  EXPECT_EQ(quantityName("trunnion_tilt"), "trunnion tilt");
}

TEST(SeriesWindow, ComparesTwoSessionsThatAreSelected) {
  SeriesBench bench;
  bench.addYear();
  EXPECT_THAT(bench.text("congruence"), HasSubstr("Select two sessions"));
  QTableWidget* table = bench.window.table();
  const auto rows = QItemSelectionModel::Rows;  // selectRow uses modifier keys left pressed by another test
  table->selectionModel()->select(table->model()->index(6, 0), QItemSelectionModel::ClearAndSelect | rows);
  table->selectionModel()->select(table->model()->index(7, 0), QItemSelectionModel::Select | rows);
  EXPECT_THAT(bench.text("congruence"), HasSubstr("Δd has changed between 2025-07-10"));
  EXPECT_THAT(bench.text("congruence"), HasSubstr("the device shows a change"));
}

TEST(SeriesWindow, NamesTheTroubleOfASession) {
  const QTemporaryDir folder;
  const QString broken = folder.filePath(QStringLiteral("broken.alidade"));
  QFile file(broken);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{");
  file.close();
  SeriesBench bench;
  bench.window.add({bench.dialogs.seriesFolder, broken});
  bench.waitUntilIdle();
  ASSERT_EQ(bench.window.table()->rowCount(), 13);
  EXPECT_EQ(bench.cell(12, 1), QStringLiteral("broken.alidade"));
  EXPECT_THAT(bench.cell(12, trouble).toStdString(), HasSubstr("line 1"));
}

// Window, console and CSV state the verdict with its tolerance and its condition in the words of the
// session's headline.
TEST(SeriesWindow, StatesTheConditionOfAVerdict) {
  Session session = paperSession();
  session.measuredOn = "2024-05-01";
  const Headline headline = headlineOf(assessGap(std::make_shared<const Evaluation>(evaluateFit(session))));
  const std::string gap = headline.line(Headline::Line::Kind::Gap);
  ASSERT_THAT(gap, HasSubstr("only if the cause is"));
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("paper.alidade"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(writeSession(session)));
  file.close();
  SeriesBench bench;
  bench.window.add({path});
  bench.waitUntilIdle();
  EXPECT_EQ(bench.cell(0, verdict).toStdString(), headline.verdictAndTolerance());
  EXPECT_THAT(headline.verdictAndTolerance(), HasSubstr("tolerance ± 2.5 mm"));
  EXPECT_THAT(bench.cell(0, condition).toStdString(), HasSubstr(gap));
  EXPECT_EQ(bench.window.table()->item(0, condition)->toolTip(), tipText(bench.cell(0, condition)));
  const std::string csv = bench.window.findChild<HistoryChart*>()->numbers();
  for (const std::string& text : {headline.verdictAndTolerance(), gap}) EXPECT_THAT(csv, HasSubstr(text));
  QProcess console;
  console.start(QFileInfo(QStringLiteral(ALIDADE_PROGRAM)).dir().filePath(QStringLiteral("alidade-cli")),
                {QStringLiteral("history"), path});
  ASSERT_TRUE(console.waitForFinished(60000));
  const std::string said = QString::fromUtf8(console.readAllStandardOutput()).simplified().toStdString();
  for (const std::string& text : {headline.verdictAndTolerance(), gap}) EXPECT_THAT(said, HasSubstr(text));
}

// Reading a pipe blocks until somebody writes to it.
TEST(SeriesWindow, ReadsNoPipe) {
  const QTemporaryDir folder;
  const QString pipe = folder.filePath(QStringLiteral("pipe.alidade"));
  ASSERT_EQ(mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
  EXPECT_TRUE(sessionPathsIn({folder.path()}).empty());
  SeriesBench bench;
  bench.window.add({pipe});
  bench.waitUntilIdle();
  ASSERT_EQ(bench.window.table()->rowCount(), 1);
  EXPECT_EQ(bench.cell(0, trouble).toStdString(), "is a pipe or a device: choose a file");
}

TEST(SeriesWindow, HasEachSessionOnce) {
  SeriesBench bench;
  bench.addYear();
  bench.addYear();
  EXPECT_EQ(bench.window.table()->rowCount(), 12);
}

TEST(SeriesWindow, CountsACopyOnceAndInThePlaceOfWhatWasTakenOut) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath(QStringLiteral("copy.alidade"));
  ASSERT_TRUE(QFile::copy(samplePath(QStringLiteral("history/2025-01-04.alidade")), copy));
  SeriesBench bench;
  bench.window.add({bench.dialogs.seriesFolder, copy});
  bench.waitUntilIdle();
  ASSERT_EQ(bench.window.table()->rowCount(), 13);
  EXPECT_EQ(bench.cell(0, trouble), QString());
  EXPECT_EQ(bench.cell(1, trouble).toStdString(),
            "holds the same readings as 2025-01-04.alidade: counted once");
  EXPECT_THAT(bench.text("history says"), HasSubstr("Weighted mean of 12 values"));
  EXPECT_EQ(bench.window.diagnosis()->sessions()->model()->rowCount(), 12);
  bench.window.table()->selectRow(0);
  bench.window.removeSelected();
  bench.waitUntilIdle();
  ASSERT_EQ(bench.window.table()->rowCount(), 12);
  EXPECT_EQ(bench.cell(0, trouble), QString()) << "it counts now";
  EXPECT_THAT(bench.text("history says"), HasSubstr("Weighted mean of 12 values"));
}

TEST(SeriesWindow, TakesSessionsOut) {
  SeriesBench bench;
  bench.addYear();
  for (int row = 7; row < 12; ++row)
    bench.window.table()->selectionModel()->select(bench.window.table()->model()->index(row, 0),
                                                   QItemSelectionModel::Select | QItemSelectionModel::Rows);
  bench.window.removeSelected();
  bench.waitUntilIdle();
  EXPECT_EQ(bench.window.table()->rowCount(), 7);
  EXPECT_THAT(bench.text("history says"), HasSubstr("Weighted mean of 7 values"));
}

// Both pages show a file as it is now.
TEST(SeriesWindow, ReadsAFileAgainThatHasChanged) {
  const QTemporaryDir folder;
  const QDir samples(samplePath(QStringLiteral("history")));
  const QStringList names = samples.entryList({QStringLiteral("*.alidade")});
  for (const QString& name : names.first(3))
    ASSERT_TRUE(QFile::copy(samples.filePath(name), folder.filePath(name)));
  SeriesBench bench;
  bench.dialogs.seriesFolder = folder.path();
  bench.addYear();
  QFile file(folder.filePath(names.first()));
  Session session = *loadSession(file.fileName().toStdString());
  session.title = "CHANGED";
  ASSERT_TRUE(file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) && file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(writeSession(session)));
  file.close();
  EXPECT_FALSE(hasChangedFile(Series()));
  EXPECT_TRUE(hasChangedFile(*bench.window.series()));
  bench.addYear();
  EXPECT_FALSE(hasChangedFile(*bench.window.series()));
  EXPECT_EQ(bench.window.table()->rowCount(), 3);
  EXPECT_EQ(bench.cell(0, 1), QStringLiteral("CHANGED"));
}

TEST(SeriesWindow, TellsOfAFolderWithoutSessions) {
  const QTemporaryDir folder;
  SeriesBench bench;
  bench.dialogs.seriesFolder = folder.path();
  bench.window.addFolder();
  ASSERT_EQ(bench.dialogs.problems.size(), 1);
  EXPECT_THAT(bench.dialogs.problems.first().toStdString(), HasSubstr("holds no session"));
  EXPECT_EQ(bench.window.table()->rowCount(), 0);
}

TEST(SeriesWindow, WritesJsonCsvAndPdf) {
  const QTemporaryDir folder;
  const auto contentOf = [](const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  };
  SeriesBench bench;
  bench.addYear();
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("h.json"));
  ASSERT_TRUE(bench.window.exportJson());
  EXPECT_EQ(nlohmann::json::parse(contentOf(bench.dialogs.exportPath).toStdString())["values"].size(), 12U);
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("h.csv"));
  ASSERT_TRUE(bench.window.exportCsv());
  EXPECT_EQ(contentOf(bench.dialogs.exportPath).count('\n'), 13);
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("h.pdf"));
  ASSERT_TRUE(bench.window.exportPdf());
  EXPECT_TRUE(contentOf(bench.dialogs.exportPath).startsWith("%PDF-"));
  // The export never overwrites a session of the series.
  bench.dialogs.exportPath = samplePath(QStringLiteral("history/2025-01-04.alidade"));
  EXPECT_FALSE(bench.window.exportJson());
}

TEST(SeriesWindow, WritesAnOfferedEffect) {
  const QTemporaryDir folder;
  SeriesBench bench;
  bench.dialogs.exportPath = folder.filePath(QStringLiteral("dent.alidade-effect"));
  const OwnEffect dent{
      .id = "dent", .formula = "radial = A*bump(s, 83°, 4°)", .parameters = {{"A", "0.2", "mm"}}};
  emit bench.window.diagnosis()->keepWanted(dent);
  const Result<OwnEffect> written = loadOwnEffect(bench.dialogs.exportPath.toStdString());
  ASSERT_TRUE(written) << written.problem().text();
  EXPECT_EQ(written->formula, dent.formula);
}

TEST(SeriesWindow, OpensASessionInTheMainWindow) {
  OpenWindow window;
  window->sideWindows().showSeries();
  auto* series = window->findChild<SeriesWindow*>();
  ASSERT_NE(series, nullptr);
  series->add({samplePath(QStringLiteral("history"))});
  ASSERT_TRUE(waitFor([&] { return !series->job().isAtWork(); }));
  emit series->table()->itemActivated(series->table()->item(3, 1));
  EXPECT_EQ(window->document().session().measuredOn, "2025-04-07");
  EXPECT_EQ(window->findChildren<SeriesWindow*>().size(), 1);
}

}  // namespace
}  // namespace alidade::ui
