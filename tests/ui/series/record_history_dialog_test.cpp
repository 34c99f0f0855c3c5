#include "ui/series/record_history_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QSpinBox>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/panels/parts/statement_view.h"
#include "ui/series/history_chart.h"
#include "ui/window/side_windows.h"

// Tools › Instrument Records…: the constants of an instrument over time.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

struct RecordBench {
  RecordBench() {
    for (const auto& [year, collimation, due] :
         {std::tuple("2023", "3.1", "2024-03-01"), std::tuple("2024", "3.3", "2025-03-01"),
          std::tuple("2025", "9.0", "2026-03-01")})
      file(QStringLiteral("r%1").arg(QString::fromLatin1(year)),
           recordOf("4711", std::string(year) + "-05-01", collimation, due));
    dialogs.seriesFolder = folder.path();
    dialog.show();
  }

  static InstrumentRecord recordOf(const std::string& serial, const std::string& date,
                                   const std::string& collimation, const std::string& due) {
    InstrumentRecord record{.name = "T-1", .serial = serial, .date = date, .due = due};
    record.known = {{.effect = "collimation", .value = collimation, .sigma = "0.5", .unit = "arcsec"},
                    {.effect = "vertical_index", .value = "-4", .sigma = "0.5", .unit = "arcsec"}};
    return record;
  }
  QString file(const QString& name, const InstrumentRecord& record) {
    QFile file(folder.filePath(name + QStringLiteral(".alidade-instrument")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(writeInstrumentRecord(record)));
    return file.fileName();
  }
  QString cell(int row, int column) { return dialog.table()->model()->index(row, column).data().toString(); }
  int rows() { return dialog.table()->model()->rowCount(); }
  QLabel* label(const char* name) { return dialog.findChild<QLabel*>(QString::fromLatin1(name)); }

  QTemporaryDir folder;
  ScriptedDialogs dialogs;
  RecordHistoryDialog dialog{dialogs};
};

TEST(RecordHistoryDialog, ShowsEachConstantOfAFolderOfRecords) {
  RecordBench bench;
  EXPECT_EQ(bench.rows(), 0);
  bench.dialog.addFolder();
  ASSERT_EQ(bench.rows(), 3);
  EXPECT_EQ(bench.cell(0, 0), QStringLiteral("2023-05-01"));
  EXPECT_EQ(bench.cell(0, 1), QStringLiteral("2024-03-01"));
  EXPECT_EQ(bench.cell(0, 4), QStringLiteral("checked late")) << "the next was on 2024-05-01";
  EXPECT_EQ(bench.cell(2, 4), QStringLiteral("overdue"));
  auto* quantities = bench.dialog.findChildren<QComboBox*>().at(1);
  ASSERT_EQ(quantities->count(), 2);
  EXPECT_EQ(bench.dialog.chart()->plot()->history().values.size(), 3U);
  EXPECT_DOUBLE_EQ(bench.dialog.chart()->plot()->history().values[2].value, 9);
  EXPECT_THAT(bench.label("record history says")->text().toStdString(), HasSubstr("mean of 3 values"));
  quantities->setCurrentIndex(1);
  emit quantities->activated(1);
  EXPECT_DOUBLE_EQ(bench.dialog.chart()->plot()->history().values[2].value, -4);
  expectAllVisible(bench.dialog, QStringLiteral("with records"));
}

TEST(RecordHistoryDialog, WatchesTheRecordsAfterItsBaseline) {
  RecordBench bench;
  bench.dialog.addFolder();
  EXPECT_FALSE(bench.dialog.chart()->plot()->history().chart.points[2].isOut &&
               bench.dialog.chart()->plot()->history().chart.baseline == 2);
  bench.dialog.findChild<QSpinBox*>()->setValue(2);
  EXPECT_EQ(bench.dialog.chart()->plot()->history().chart.baseline, 2U);
  EXPECT_TRUE(bench.dialog.chart()->plot()->history().chart.points[2].isOut) << "9.0″ after 3.2″";
}

TEST(RecordHistoryDialog, KeepsInstrumentsApartAndNamesWhatTakesNoPart) {
  RecordBench bench;
  bench.file(QStringLiteral("other"), RecordBench::recordOf("5000", "2025-01-01", "1", ""));
  bench.file(QStringLiteral("twice"), RecordBench::recordOf("5000", "2025-01-01", "1", ""));
  QFile broken(bench.folder.filePath(QStringLiteral("s.alidade-instrument")));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("{");
  broken.close();
  bench.dialog.addFolder();
  auto* instruments = bench.dialog.findChildren<QComboBox*>().at(0);
  ASSERT_EQ(instruments->count(), 2);
  EXPECT_TRUE(instruments->isVisible());
  const std::string remarks = bench.label("record remarks")->text().toStdString();
  EXPECT_THAT(remarks, HasSubstr("s.alidade-instrument: "));
  EXPECT_THAT(remarks,
              HasSubstr("twice.alidade-instrument holds the same record as other.alidade-instrument"));
  instruments->setCurrentIndex(1);
  emit instruments->activated(1);
  bench.dialog.addFolder();
  ASSERT_EQ(bench.dialogs.problems.size(), 1) << "nothing new is in the folder";
}

TEST(RecordHistoryDialog, WritesJsonAndCsvButNotOverARecord) {
  RecordBench bench;
  bench.dialog.addFolder();
  const auto written = [&](const char* name, bool (RecordHistoryDialog::*write)()) {
    bench.dialogs.exportPath = bench.folder.filePath(QString::fromLatin1(name));
    EXPECT_TRUE((bench.dialog.*write)());
    QFile file(bench.dialogs.exportPath);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll().toStdString();
  };
  const auto json = nlohmann::json::parse(written("h.json", &RecordHistoryDialog::exportJson));
  EXPECT_EQ(json["instruments"][0]["quantities"]["collimation"]["values"].size(), 3U);
  EXPECT_THAT(written("h.csv", &RecordHistoryDialog::exportCsv), HasSubstr("2025-05-01,"));
  bench.dialogs.exportPath = bench.folder.filePath(QStringLiteral("r2023.alidade-instrument"));
  EXPECT_FALSE(bench.dialog.exportJson());
}

TEST(RecordHistoryDialog, OpensFromTheMainWindow) {
  OpenWindow open;
  open->sideWindows().showRecordHistory();
  open->sideWindows().showRecordHistory();
  ASSERT_EQ(open->findChildren<RecordHistoryDialog*>().size(), 1);
  EXPECT_TRUE(open->findChild<RecordHistoryDialog*>()->isVisible());
}

}  // namespace
}  // namespace alidade::ui
