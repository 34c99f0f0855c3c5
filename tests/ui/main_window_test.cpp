#include "ui/main_window.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProcess>
#include <QSplitter>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/document/session_template.h"
#include "ui/panels/parts/frames.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/panels/result/findings_panel.h"
#include "ui/panels/result/result_panel.h"
#include "ui/report/empty_fields.h"
#include "ui/settings/recent_files.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

const QString paper = QStringLiteral("paper-table-1.alidade");

QLineEdit& field(OpenWindow& open, const char* name) {
  auto* line = open->findChild<QLineEdit*>(QString::fromLatin1(name));
  EXPECT_TRUE(line) << name;
  return *line;
}

/// All texts the widget's labels show.
std::string shownBy(const QWidget* widget) {
  QString texts;
  for (const QLabel* label : widget->findChildren<QLabel*>()) {
    if (label->isVisibleTo(widget)) texts += label->text() + QLatin1Char('\n');
  }
  return texts.toStdString();
}

std::string resultOf(OpenWindow& open) {
  return shownBy(open->findChild<ResultPanel*>());
}

/// The words of a PDF, according to poppler.
std::string printedText(const QString& path) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), path, QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished());
  return reader.readAllStandardOutput().toStdString();
}

void loadPaper(OpenWindow& open) {
  ASSERT_TRUE(open->files().open(samplePath(paper)));
  open.waitUntilIdle();
}

TEST(MainWindow, FitsAMeasurementTypedByKeyboardAlone) {
  const Session wanted = paperSession();
  OpenWindow open;
  EXPECT_THAT(resultOf(open), HasSubstr("No result"));
  typeInto(field(open, "geometry.distance_mm"), QStringLiteral("2405"));
  typeInto(field(open, "geometry.radius_mm"), QStringLiteral("400"));
  auto* tabs = open->findChild<PositionTabs*>();
  for (std::size_t position = 0; position < 2; ++position) {
    tabs->setCurrentIndex(static_cast<int>(position));
    const Position& source = wanted.positions[position];
    const QByteArray suffix = QByteArray(" ") + QByteArray::number(static_cast<int>(position));
    typeInto(field(open, "pointing_zero.horizontal" + suffix),
             QString::fromStdString(source.zero.horizontal));
    typeInto(field(open, "pointing_zero.vertical" + suffix), QString::fromStdString(source.zero.vertical));
    ReadingsTable& table = *tabs->table(position);
    table.selectCell(0, ReadingColumn::Horizontal);
    for (const Reading& reading : source.readings) {
      typeInto(table, QString::fromStdString(reading.horizontal));
      typeInto(table, QString::fromStdString(reading.vertical));
    }
  }
  open.waitUntilIdle();
  const Session& typed = open->document().session();
  for (std::size_t position = 0; position < 2; ++position) {
    const auto& readings = typed.positions[position].readings;
    ASSERT_EQ(readings.size(), 17u);
    for (std::size_t row = 0; row < readings.size(); ++row) {
      EXPECT_EQ(readings[row].horizontal, wanted.positions[position].readings[row].horizontal);
      EXPECT_EQ(readings[row].vertical, wanted.positions[position].readings[row].vertical);
      EXPECT_EQ(readings[row].point, std::to_string(row + 1));
    }
  }
  EXPECT_THAT(resultOf(open), HasSubstr("Δd, fit only = 1.31 ±"));
  typeInto(field(open, "acceptance.tolerance_mm"), QStringLiteral("2.5"));
  open.waitUntilIdle();
  EXPECT_THAT(resultOf(open), HasSubstr("Provisional: the diagnosis is running.\n"));
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_THAT(resultOf(open),
              testing::AllOf(HasSubstr("Δd = 1."), HasSubstr("Accepted\ntolerance ± 2.5 mm\n")));
  EXPECT_THAT(resultOf(open), Not(HasSubstr("Provisional")));
}

// Δd, fit only, is within the tolerance; Δd, measured, is undecided.
TEST(MainWindow, ShowsNoVerdictThatTheDiagnosisContradicts) {
  OpenWindow open;
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("two-causes.alidade"))));
  field(open, "acceptance.tolerance_mm").selectAll();
  typeInto(field(open, "acceptance.tolerance_mm"), QStringLiteral("0.43"));
  open.waitUntilIdle();
  EXPECT_THAT(resultOf(open), HasSubstr("Provisional: the diagnosis is running.\n"));
  EXPECT_THAT(resultOf(open), Not(HasSubstr("Accepted\n")));
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_THAT(resultOf(open), HasSubstr("Undecided\n"));
  const std::string shown = QString::fromStdString(resultOf(open)).simplified().toStdString();
  EXPECT_THAT(shown,
              testing::ContainsRegex("Δd = 0\\.4[0-9]+ ± 0\\.[01][0-9]+ mm Undecided tolerance ± 0\\.43 mm"));
  EXPECT_THAT(shown, HasSubstr("Δd from the fit only, 0.383 mm ± 0.038 mm"));
}

// Only the page in front receives evaluations.
TEST(MainWindow, ShowsTheVerdictOfADiagnosisThatEndedBehindAnotherPage) {
  OpenWindow open;
  loadPaper(open);
  auto* result = open->findChild<ResultPanel*>();
  auto* pages = qobject_cast<QTabWidget*>(result->parentWidget()->parentWidget());
  ASSERT_TRUE(pages);
  pages->setCurrentIndex(1);
  typeInto(field(open, "acceptance.tolerance_mm"), QStringLiteral("3"));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  pages->setCurrentIndex(0);
  EXPECT_THAT(resultOf(open), HasSubstr("Accepted\n"));
  EXPECT_THAT(resultOf(open), Not(HasSubstr("Provisional")));
}

// A single unusable entry suffices, among usable ones of its form.
TEST(MainWindow, MarksTheFormOfAnEntryThatCannotBeUsed) {
  OpenWindow open;
  loadPaper(open);
  QLineEdit& distance = field(open, "geometry.distance_mm");
  const auto isMarked = [&] {
    for (const auto* tabs : open->findChildren<QTabWidget*>())
      for (int tab = 0; tab < tabs->count(); ++tab)
        if (tabs->widget(tab)->isAncestorOf(&distance)) return !tabs->tabIcon(tab).isNull();
    return false;
  };
  EXPECT_FALSE(isMarked());
  changeField(open->document(), {.field = "geometry.distance_mm"}, "far");
  open.waitUntilIdle();
  EXPECT_TRUE(isMarked());
  open->undo();
  open.waitUntilIdle();
  EXPECT_FALSE(isMarked());
}

// The report gives no verdict either.
TEST(MainWindow, GivesNoVerdictWithAnEntryThatCannotBeUsed) {
  OpenWindow open;
  loadPaper(open);
  ReadingsTable& table = *open->currentTable();
  table.selectCell(3, ReadingColumn::Vertical);
  typeInto(table, QStringLiteral("86 71 00"));
  open.waitUntilIdle();
  ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
  EXPECT_THAT(resultOf(open), HasSubstr("No verdict: 1 entry could not be used"));
  EXPECT_THAT(resultOf(open), Not(HasSubstr("Accepted")));
  EXPECT_THAT(resultOf(open), HasSubstr("Δd = "));
}

TEST(MainWindow, KeepsAWrongAngleOutOfTheFitAndFindsItBack) {
  OpenWindow open;
  loadPaper(open);
  ReadingsTable& table = *open->currentTable();
  table.selectCell(4, ReadingColumn::Vertical);
  typeInto(table, QStringLiteral("82 99 39"));
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session().positions[0].readings[4].vertical, "82 99 39");
  EXPECT_THAT(resultOf(open), HasSubstr("16"));
  const QModelIndex residual = table.model()->index(4, static_cast<int>(ReadingColumn::VerticalResidual));
  EXPECT_TRUE(residual.data().toString().isEmpty());
  auto* findings = open->findChild<FindingsPanel*>();
  EXPECT_THAT(findings->item(0)->text().toStdString(), HasSubstr("0°, row 5 (point 5), vertical reading: "));
  table.selectCell(0, ReadingColumn::Horizontal);
  emit findings->itemClicked(findings->item(0));
  EXPECT_EQ(table.currentIndex().row(), 4);
  EXPECT_EQ(table.currentIndex().column(), static_cast<int>(ReadingColumn::Vertical));
  open->undo();
  open.waitUntilIdle();
  EXPECT_FALSE(residual.data().toString().isEmpty());
  EXPECT_FALSE(open->isWindowModified());
}

TEST(MainWindow, ListsWhatIsWrongBeforeWhatIsMissing) {
  OpenWindow open;  // a new session: L, R0 and the zeros are missing
  ReadingsTable& table = *open->currentTable();
  table.selectCell(0, ReadingColumn::Horizontal);
  typeInto(table, QStringLiteral("341 99 24"));
  open.waitUntilIdle();
  const auto* findings = open->findChild<FindingsPanel*>();
  ASSERT_GT(findings->count(), 1);
  EXPECT_THAT(findings->item(0)->text().toStdString(), HasSubstr("99 minutes"));
}

TEST(MainWindow, ShowsEveryProblemUntilAPersonSetsTheHeight) {
  OpenWindow open;
  open->resize(1280, 1600);
  loadPaper(open);
  ReadingsTable& table = *open->currentTable();
  const auto* findings = open->findChild<FindingsPanel*>();
  for (const int row : {2, 5, 7, 9}) {
    table.selectCell(row, ReadingColumn::Vertical);
    typeInto(table, QStringLiteral("82 99 39"));
  }
  open.waitUntilIdle();
  ASSERT_GE(findings->count(), 4);
  EXPECT_GE(findings->height(), findings->wholeHeight());
  for (const int line : {0, findings->count() - 1})
    EXPECT_TRUE(findings->viewport()->rect().contains(findings->visualItemRect(findings->item(line))))
        << line;
  EXPECT_TRUE(table.viewport()->rect().contains(table.visualRect(table.currentIndex())));
  EXPECT_GE(table.viewport()->height(), 5 * table.rowHeight(0)) << "rows remain to type in";
  auto* column = open->findChild<QSplitter*>(QStringLiteral("entries"));
  markSetByHand(*column);
  column->setSizes({10'000, 1});
  const int height = findings->height();
  EXPECT_LT(height, findings->wholeHeight());
  table.selectCell(11, ReadingColumn::Vertical);
  typeInto(table, QStringLiteral("82 99 39"));
  open.waitUntilIdle();
  EXPECT_EQ(findings->height(), height);
}

TEST(MainWindow, LeadsFromAFindingToItsField) {
  OpenWindow open;
  open->reveal({.position = 1, .field = "pointing_zero.vertical"});
  EXPECT_EQ(open->findChild<PositionTabs*>()->currentIndex(), 1);
  EXPECT_TRUE(field(open, "pointing_zero.vertical 1").hasFocus());
  open->reveal({.field = "instrument.sigma_zero_arcsec"});
  EXPECT_TRUE(field(open, "instrument.sigma_zero_arcsec").hasFocus());
}

TEST(MainWindow, TellsThePublishedFiguresOnRequest) {
  OpenWindow open;
  loadPaper(open);
  EXPECT_THAT(resultOf(open), Not(HasSubstr("1.934")));
  open->findChild<ResultPanel*>()->findChild<QCheckBox*>()->click();
  const std::string shown = resultOf(open);
  for (const char* printed : {"−0.0091", "−0.0318", "−0.9719", "−1.4923", "1.8143", "−2.0538", "1.934"}) {
    EXPECT_THAT(shown, HasSubstr(printed));
  }
}

TEST(MainWindow, CarriesNameAndModifiedMarkInTheTitle) {
  OpenWindow open;
  const auto title = [](const QString& name) {
    return name + QStringLiteral("[*] — %1 — Alidade").arg(QCoreApplication::applicationVersion());
  };
  EXPECT_EQ(open->windowTitle(), title(QStringLiteral("Untitled")));
  loadPaper(open);
  EXPECT_EQ(open->windowTitle(), title(QStringLiteral("paper-table-1.alidade")));
  EXPECT_FALSE(open->isWindowModified());
  typeInto(field(open, "acceptance.tolerance_mm"), QStringLiteral("3"));
  EXPECT_TRUE(open->isWindowModified());
  open->undo();
  EXPECT_FALSE(open->isWindowModified());
}

TEST(MainWindow, AsksBeforeUnsavedChangesAreLeft) {
  OpenWindow open;
  loadPaper(open);
  EXPECT_TRUE(open->files().mayLeave());
  EXPECT_EQ(open.dialogs->saveQuestions, 0);
  changeField(open->document(), {.field = "title"}, "changed");
  EXPECT_FALSE(open->close());
  EXPECT_EQ(open.dialogs->saveQuestions, 1);
  EXPECT_FALSE(open->files().startNew());
  EXPECT_EQ(open->document().session().title, "changed");
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  EXPECT_TRUE(open->files().startNew());
  EXPECT_EQ(open->document().session(), templateSession());
  EXPECT_FALSE(open->isWindowModified());
}

TEST(MainWindow, SavesBeforeLeavingWhereWanted) {
  const QTemporaryDir folder;
  OpenWindow open;
  changeField(open->document(), {.field = "title"}, "kept");
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Save;
  EXPECT_FALSE(open->close()) << "no file was chosen";
  open.dialogs->savePath = folder.filePath(QStringLiteral("kept.alidade"));
  EXPECT_TRUE(open->close());
  const Result<Session> saved = loadSession(open.dialogs->savePath.toStdString());
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->title, "kept");
}

TEST(MainWindow, HandsInWhatIsHalfTypedBeforeSaving) {
  const QTemporaryDir folder;
  OpenWindow open;
  open.dialogs->savePath = folder.filePath(QStringLiteral("half.alidade"));
  ReadingsTable& table = *open->currentTable();
  table.selectCell(0, ReadingColumn::Horizontal);
  table.setFocus();
  QTest::keyClicks(&table, QStringLiteral("3"));
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("415224"));
  EXPECT_TRUE(open->document().session().positions[0].readings.empty());
  ASSERT_TRUE(open->files().save());
  EXPECT_EQ(loadSession(open.dialogs->savePath.toStdString())->positions[0].readings.at(0).horizontal,
            "3415224");
  field(open, "title").setFocus();
  QTest::keyClicks(&field(open, "title"), QStringLiteral("half"));
  ASSERT_TRUE(open->files().save());
  EXPECT_EQ(loadSession(open.dialogs->savePath.toStdString())->title, "half");
  EXPECT_FALSE(open->isWindowModified());
}

TEST(MainWindow, HandsInWhatIsHalfTypedBeforeTheNextSession) {
  OpenWindow open;
  field(open, "acceptance.tolerance_mm").setFocus();
  QTest::keyClicks(&field(open, "acceptance.tolerance_mm"), QStringLiteral("0.9"));
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  ASSERT_TRUE(open->files().startNext());
  EXPECT_EQ(open->document().session().acceptance.toleranceMm, "0.9");
}

TEST(MainWindow, KeepsUnknownKeysThroughEditAndSave) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("more.alidade"));
  QFile sample(samplePath(paper));
  ASSERT_TRUE(sample.open(QIODevice::ReadOnly));
  auto json = nlohmann::ordered_json::parse(sample.readAll().toStdString());
  json["weather"] = "fog";
  json["positions"][0]["readings"][3]["clock"] = "10:04";
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(json.dump()));
  file.close();

  OpenWindow open;
  ASSERT_TRUE(open->files().open(path));
  ReadingsEditor(open->document(), 0).setCell({3, ReadingColumn::Vertical}, "83 50 35");
  ASSERT_TRUE(open->files().save());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  auto saved = nlohmann::ordered_json::parse(file.readAll().toStdString());
  EXPECT_EQ(saved["journal"].size(), 1U);
  saved.erase("journal");
  auto& row = json["positions"][0]["readings"][3];
  row["as_read"]["vertical"] = row["vertical"];
  row["vertical"] = "83 50 35";
  EXPECT_EQ(saved, json);
}

TEST(MainWindow, SaysWhyAFileDoesNotOpenAndStaysAsItWas) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("broken.alidade"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"alidade-session\", \"version\": 99}");
  file.close();
  OpenWindow open;
  loadPaper(open);
  EXPECT_FALSE(open->files().open(path));
  EXPECT_FALSE(open->files().open(folder.filePath(QStringLiteral("absent.alidade"))));
  ASSERT_EQ(open.dialogs->problems.size(), 2);
  EXPECT_THAT(open.dialogs->problems[0].toStdString(), HasSubstr("version"));
  EXPECT_EQ(open->document().session(), paperSession());
}

TEST(MainWindow, SaysWhyASessionCannotBeSaved) {
  OpenWindow open;
  open.dialogs->savePath = QStringLiteral("/nowhere/at/all.alidade");
  changeField(open->document(), {.field = "title"}, "kept");
  EXPECT_FALSE(open->files().save());
  EXPECT_EQ(open.dialogs->problems.size(), 1);
  EXPECT_TRUE(open->isWindowModified());
}

TEST(MainWindow, FollowsAnExclusion) {
  OpenWindow open;
  loadPaper(open);
  const std::string before = resultOf(open);
  open->currentTable()->selectCell(0, ReadingColumn::Horizontal);
  open->currentTable()->toggleExcluded();
  open.waitUntilIdle();
  EXPECT_NE(resultOf(open), before);
  open->undo();
  open.waitUntilIdle();
  EXPECT_EQ(resultOf(open), before);
}

TEST(MainWindow, WritesTheAcceptanceReport) {
  const QTemporaryDir folder;
  OpenWindow open;
  loadPaper(open);
  open.dialogs->reportPath = folder.filePath(QStringLiteral("report.pdf"));
  ASSERT_TRUE(open->files().exportReport());
  QFile report(open.dialogs->reportPath);
  ASSERT_TRUE(report.open(QIODevice::ReadOnly));
  EXPECT_TRUE(report.readAll().startsWith("%PDF-1."));
  EXPECT_TRUE(open.dialogs->unusableEntries.isEmpty()) << "nothing to ask about";
  ASSERT_EQ(open.dialogs->emptyFields.size(), 1);
  EXPECT_EQ(open.dialogs->emptyFields[0], emptyReportFields(paperSession()));
}

TEST(MainWindow, WritesNoReportWhereEmptyFieldsAreToBeFilledIn) {
  const QTemporaryDir folder;
  OpenWindow open;
  loadPaper(open);
  open.dialogs->reportPath = folder.filePath(QStringLiteral("report.pdf"));
  open.dialogs->writeAnyway = false;
  EXPECT_FALSE(open->files().exportReport());
  EXPECT_FALSE(QFile::exists(open.dialogs->reportPath));
}

TEST(MainWindow, AsksBeforeAReportWithoutVerdict) {
  const QTemporaryDir folder;
  OpenWindow open;
  loadPaper(open);
  open.dialogs->reportPath = folder.filePath(QStringLiteral("report.pdf"));
  ReadingsEditor(open->document(), 0).setCell({3, ReadingColumn::Vertical}, "x");
  ReadingsEditor(open->document(), 1).setCell({5, ReadingColumn::Horizontal}, "y");
  EXPECT_FALSE(open->files().exportReport());
  EXPECT_FALSE(QFile::exists(open.dialogs->reportPath));
  open.dialogs->exportAnyway = true;
  ASSERT_TRUE(open->files().exportReport());
  EXPECT_EQ(open.dialogs->unusableEntries, QList<int>({2, 2}));
  EXPECT_TRUE(open.dialogs->problems.isEmpty());
  const std::string printed = printedText(open.dialogs->reportPath);
  EXPECT_THAT(printed, HasSubstr("No verdict: 2 entries could not be used"));
  EXPECT_THAT(printed, HasSubstr("row 4 (point 4)"));
  for (const char* word : {"Accepted\n", "Rejected\n", "Undecided\n"})
    EXPECT_THAT(printed, Not(HasSubstr(word)));
}

TEST(RecentFiles, ListsTheNewestFirstAndLeavesOutWhatIsNotThere) {
  const QTemporaryDir folder;
  RecentFiles::clear();
  QStringList paths;
  for (int i = 0; i < 12; ++i) {
    paths.prepend(folder.filePath(QStringLiteral("%1.alidade").arg(i)));
    QFile(paths.first()).open(QIODevice::WriteOnly);
    RecentFiles::add(paths.first());
  }
  EXPECT_EQ(RecentFiles::existing(), paths.mid(0, 10));
  RecentFiles::add(paths[5]);
  EXPECT_EQ(RecentFiles::existing().first(), paths[5]);
  QFile::rename(paths[5], paths[5] + QLatin1Char('x'));
  EXPECT_FALSE(RecentFiles::existing().contains(paths[5]));
  QFile::rename(paths[5] + QLatin1Char('x'), paths[5]);
  EXPECT_EQ(RecentFiles::existing().first(), paths[5]) << "left out, but not forgotten";
}

TEST(Workstation, WritesAReportWithoutADisplay) {
  const QTemporaryDir folder;
  const QString out = folder.filePath(QStringLiteral("report.pdf"));
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    environment.remove(QString::fromLatin1(name));
  }
  program.setProcessEnvironment(environment);
  const auto run = [&](const QStringList& arguments) {
    program.start(QStringLiteral(ALIDADE_PROGRAM), arguments);
    EXPECT_TRUE(program.waitForFinished());
    return program.exitCode();
  };
  EXPECT_EQ(run({QStringLiteral("--report"), out, samplePath(paper)}), 0);
  const QString errors = QString::fromUtf8(program.readAllStandardError());
  EXPECT_EQ(errors.toStdString(),
            QStringLiteral("%1: The report says “not stated” for: %2.\n")
                .arg(samplePath(paper), emptyReportFields(paperSession()).join(QStringLiteral(", ")))
                .toStdString());
  EXPECT_GT(QFile(out).size(), 10000);
  EXPECT_EQ(run({QStringLiteral("--report"), out, QStringLiteral("/absent.alidade")}), 2);
  EXPECT_EQ(program.readAllStandardError().count('\n'), 1);
  EXPECT_EQ(run({QStringLiteral("--report"), out}), 2);
  EXPECT_EQ(program.readAllStandardError().count('\n'), 1);
  // The command never overwrites the session, under any of its names; it writes to standard output on
  // request.
  const QString session = folder.filePath(QStringLiteral("s.alidade")),
                link = folder.filePath(QStringLiteral("link.pdf"));
  ASSERT_TRUE(QFile::copy(samplePath(paper), session) && QFile::link(session, link));
  QFile::setPermissions(session, QFile::ReadOwner | QFile::WriteOwner);
  for (const QString& target : {session, link}) {
    EXPECT_EQ(run({QStringLiteral("--report"), target, session}), 2);
    EXPECT_THAT(program.readAllStandardError().toStdString(), HasSubstr("this is the file being read"));
  }
  EXPECT_EQ(*loadSession(session.toStdString()), paperSession());
  EXPECT_EQ(run({QStringLiteral("--report"), QStringLiteral("/dev/full"), session}), 2);
  EXPECT_THAT(program.readAllStandardError().toStdString(), HasSubstr("the disk is full"));
  EXPECT_EQ(run({QStringLiteral("--report"), QStringLiteral("/dev/stdout"), session}), 0);
  EXPECT_TRUE(program.readAllStandardOutput().startsWith("%PDF-1."));
  EXPECT_EQ(run({QStringLiteral("--unknown")}), 2);
  EXPECT_EQ(run({QStringLiteral("--help")}), 0);
  EXPECT_THAT(program.readAllStandardOutput().toStdString(), HasSubstr("--report"));
}

}  // namespace
}  // namespace alidade::ui
