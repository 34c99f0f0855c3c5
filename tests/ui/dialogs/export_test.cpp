// Exports from the window, as other programs read them.

#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QMenuBar>
#include <QProcess>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/exchange/import.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/charts/gap/closure_bars.h"
#include "ui/charts/gap/gap_map.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"

namespace alidade::ui {
namespace {

class Export : public ::testing::Test {
 protected:
  QString pathOf(const QString& name) const { return folder.filePath(name); }
  QByteArray bytesOf(const QString& name) const {
    QFile file(pathOf(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void openSample(const QString& name) {
    ASSERT_TRUE(open->files().open(samplePath(name)));
    open.waitUntilIdle();
  }
  /// Exports by the menu File › Export.
  void exportAs(const QString& entry, const QString& name) {
    open.dialogs->exportPath = name.isEmpty() ? QString() : pathOf(name);
    for (QAction* action : open->findChildren<QAction*>())
      if (action->text().remove(u'&') == entry) return action->trigger();
    FAIL() << entry.toStdString() << " is in no menu";
  }
  static QByteArray printedBy(const QStringList& arguments) {
    QProcess console;
    console.start(QStringLiteral(ALIDADE_CLI), arguments);
    EXPECT_TRUE(console.waitForFinished(60000));
    return console.readAllStandardOutput();
  }

  QTemporaryDir folder;
  OpenWindow open;
};

TEST_F(Export, ReadingsCanBeImportedAgain) {
  openSample(QStringLiteral("two-faces.alidade"));
  exportAs(QStringLiteral("Readings (CSV)…"), QStringLiteral("rows.csv"));
  EXPECT_TRUE(open.dialogs->exportSuggested.endsWith(QStringLiteral("/two-faces-readings.csv")));
  EXPECT_TRUE(open->statusBar()->currentMessage().contains(QStringLiteral("rows.csv")));
  const Session written = open->document().session();
  open->files().startNew();
  ASSERT_TRUE(open->files().importReadings({pathOf(QStringLiteral("rows.csv"))}));
  const Session& read = open->document().session();
  ASSERT_EQ(read.positions.size(), written.positions.size());
  for (std::size_t p = 0; p < written.positions.size(); ++p) {
    ASSERT_EQ(read.positions[p].readings.size(), written.positions[p].readings.size());
    for (std::size_t row = 0; row < written.positions[p].readings.size(); ++row) {
      EXPECT_EQ(read.positions[p].readings[row].horizontal, written.positions[p].readings[row].horizontal);
      EXPECT_EQ(read.positions[p].readings[row].vertical, written.positions[p].readings[row].vertical);
      EXPECT_EQ(read.positions[p].readings[row].face, written.positions[p].readings[row].face);
    }
  }
}

TEST_F(Export, ResultAndGapAreWhatTheConsolePrints) {
  for (const char* sample : {"paper-table-1.alidade", "knocked-tripod.alidade"}) {
    const QString name = QString::fromLatin1(sample);
    openSample(name);
    exportAs(QStringLiteral("Result (JSON)…"), QStringLiteral("result.json"));
    EXPECT_EQ(bytesOf(QStringLiteral("result.json")),
              printedBy({QStringLiteral("fit"), samplePath(name), QStringLiteral("--json")}));
    exportAs(QStringLiteral("Gap (JSON)…"), QStringLiteral("gap.json"));
    EXPECT_EQ(bytesOf(QStringLiteral("gap.json")),
              printedBy({QStringLiteral("diagnose"), samplePath(name), QStringLiteral("--json")}));
  }
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(Export, HoldsWhatIsHalfTyped) {
  openSample(QStringLiteral("paper-table-1.alidade"));
  open->reveal({.position = 0, .reading = 3, .field = "vertical"});
  for (const QChar key : QStringLiteral("85 10 07"))  // without Enter
    QTest::keyClicks(QApplication::focusWidget(), key);
  exportAs(QStringLiteral("Readings (CSV)…"), QStringLiteral("rows.csv"));
  EXPECT_TRUE(bytesOf(QStringLiteral("rows.csv")).contains(",85 10 07,"));
}

TEST_F(Export, ResidualsAndBudgetAreTables) {
  openSample(QStringLiteral("paper-table-1.alidade"));
  exportAs(QStringLiteral("Residuals (CSV)…"), QStringLiteral("v.csv"));
  EXPECT_EQ(bytesOf(QStringLiteral("v.csv")).count('\n'), 1 + 68);
  exportAs(QStringLiteral("Budget (CSV)…"), QStringLiteral("u.csv"));
  const QByteArray budget = bytesOf(QStringLiteral("u.csv"));
  EXPECT_TRUE(budget.startsWith("quantity,"));
  EXPECT_TRUE(budget.contains("intersection_as_measured,,,"));
}

TEST_F(Export, TellsWhyThereIsNothing) {
  exportAs(QStringLiteral("Readings (CSV)…"), QStringLiteral("none.csv"));
  exportAs(QStringLiteral("Result (JSON)…"), QStringLiteral("none.json"));
  openSample(QStringLiteral("paper-table-1.alidade"));
  ReadingsEditor(open->document(), 0).setCell({2, ReadingColumn::Vertical}, "85 99 00");
  exportAs(QStringLiteral("Residuals (CSV)…"), QStringLiteral("none.csv"));
  ASSERT_EQ(open.dialogs->problems.size(), 3);
  EXPECT_TRUE(open.dialogs->problems[0].contains(QStringLiteral("no readings")));
  EXPECT_TRUE(open.dialogs->problems[2].contains(QStringLiteral("vertical")))
      << open.dialogs->problems[2].toStdString();
  EXPECT_TRUE(bytesOf(QStringLiteral("none.csv")).isEmpty());
}

TEST_F(Export, WritesNothingWhereItIsCancelledOrCannot) {
  openSample(QStringLiteral("paper-table-1.alidade"));
  exportAs(QStringLiteral("Readings (CSV)…"), {});
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
  exportAs(QStringLiteral("Readings (CSV)…"), QStringLiteral("no folder/rows.csv"));
  ASSERT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_TRUE(open.dialogs->problems[0].contains(QStringLiteral("no folder")));
}

TEST_F(Export, NeverReplacesTheSession) {
  const QString own = pathOf(QStringLiteral("own.alidade"));
  ASSERT_TRUE(QFile::copy(samplePath(QStringLiteral("paper-table-1.alidade")), own));
  QFile::setPermissions(own, QFile::ReadOwner | QFile::WriteOwner);
  ASSERT_TRUE(open->files().open(own));
  open.waitUntilIdle();
  const QByteArray before = bytesOf(QStringLiteral("own.alidade"));
  exportAs(QStringLiteral("Readings (CSV)…"), QStringLiteral("own.alidade"));
  EXPECT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_EQ(bytesOf(QStringLiteral("own.alidade")), before);
}

TEST_F(Export, ChartsOfTheWindowAreWritten) {
  openSample(QStringLiteral("knocked-tripod.alidade"));
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  const auto files = open->findChildren<ChartFiles*>();
  ASSERT_EQ(files.size(), 8) << "arcs, residuals, three of the gap, and one for each form";
  int number = 0;
  for (ChartFiles* chart : files) {
    auto* source = dynamic_cast<ChartSource*>(chart->parent());
    ASSERT_TRUE(source);
    QMenu menu;
    chart->addTo(menu);
    for (const char* suffix : {"svg", "png", "csv"}) {
      const QString name = QStringLiteral("chart-%1.%2").arg(++number).arg(QString::fromLatin1(suffix));
      open.dialogs->exportPath = pathOf(name);
      for (QAction* action : menu.actions())
        if (action->text().remove(u'&').contains(QString::fromLatin1(suffix).toUpper())) action->trigger();
      EXPECT_FALSE(bytesOf(name).isEmpty()) << name.toStdString();
      EXPECT_TRUE(open.dialogs->exportSuggested.endsWith(
          QStringLiteral("-%1.%2").arg(source->fileName(), QString::fromLatin1(suffix))));
    }
    EXPECT_GE(source->numbers().size(), 30u);
  }
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
}

TEST_F(Export, TablesOfTheGapAreThoseOfTheDiagnosis) {
  SharedGap gap;
  QObject::connect(&open->gapJob(), &GapJob::assessed, open.window.get(),
                   [&](const SharedGap& assessed) { gap = assessed; });
  openSample(QStringLiteral("knocked-tripod.alidade"));
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle() && gap; }));
  const auto rowsOf = [](const std::string& csv) { return std::count(csv.begin(), csv.end(), '\n'); };
  EXPECT_EQ(rowsOf(open->findChild<ClosureBars*>()->numbers()),
            1 + static_cast<long>(gap->diagnosis->closures.size()));
  const std::string where = open->findChild<GapMap*>()->numbers();
  EXPECT_EQ(where.substr(0, where.find('\n')), "by,part,share");
  EXPECT_GT(rowsOf(where), 3);
}

TEST_F(Export, AStepInAChartSelectsTheRowAndKeepsTheKeyboard) {
  openSample(QStringLiteral("paper-table-1.alidade"));
  auto* chart = open->findChild<ResidualChart*>();
  chart->setFocus();
  ASSERT_TRUE(chart->hasFocus());
  for (int i = 0; i < 5; ++i) {
    QTest::keyClick(chart, Qt::Key_Right);
    EXPECT_TRUE(chart->hasFocus());
    ASSERT_TRUE(chart->plot()->current());
    EXPECT_EQ(chart->plot()->markers().highlighted(), chart->plot()->current()->ref);
  }
}

}  // namespace
}  // namespace alidade::ui
