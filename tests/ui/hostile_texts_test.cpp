#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProcess>
#include <QStatusBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolTip>

#include "core/session/row_fields.h"
#include "core/session/session_file.h"
#include "tests/support/hostile_session.h"
#include "tests/ui/report/printed.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/support.h"
#include "ui/commands/edit_readings.h"
#include "ui/forms/field_edit.h"
#include "ui/forms/field_notes.h"
#include "ui/import/import_page.h"
#include "ui/main_window.h"
#include "ui/panels/window/page_tabs.h"
#include "ui/settings/recent_files.h"

// Window and report show any content of names, notes and files as text, and preserve it.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::ordered_json;

QString of(const std::string& text) {
  return QString::fromStdString(text);
}

std::string hostilePaperText(const std::string& text) {
  return test::hostileSession(writeSession(paperSession()), text);
}

/// A session text in which every entry is unusable.
std::string brokenPaperText(const std::string& text) {
  Json json = Json::parse(hostilePaperText(text));
  json["measured_on"] = text;
  json["environment"]["temperature_c"] = text;
  for (const char* key :
       {"distance_mm", "sigma_distance_mm", "radius_mm", "sigma_radius_mm", "vertical_circle"})
    json["geometry"][key] = text;
  for (const char* key : {"tolerance_mm", "coverage", "reference_intersection_mm", "sigma_reference_mm"})
    json["acceptance"][key] = text;
  for (const char* key : {"sigma_horizontal_arcsec", "sigma_vertical_arcsec", "sigma_zero_arcsec"})
    json["instrument"][key] = text;
  json["model"]["vertical_angle"] = json["model"]["radius"] = text;
  json["positions"][1]["axis_deg"] = text;
  for (Json& position : json["positions"]) {
    for (const char* key : {"horizontal", "vertical"}) position["pointing_zero"][key] = text;
    for (const RowField& field : rowFields)
      if (field.text && !isFreeText(field)) position["readings"][3][field.key] = text;
  }
  return json.dump();
}

class HostileTextsTest : public testing::Test {
 protected:
  /// Creates a file of that name.
  QString file(const std::string& name, const std::string& content) const {
    QFile file(folder.filePath(of(name)));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly)) << name;
    file.write(content.data(), static_cast<qint64>(content.size()));
    return file.fileName();
  }

  static void load(OpenWindow& open, const QString& path) {
    ASSERT_TRUE(open->files().open(path)) << open.dialogs->problems.join(u'\n').toStdString();
    open.waitUntilIdle();
    ASSERT_TRUE(waitFor([&] { return open->gapJob().isIdle(); }));
    QCoreApplication::processEvents();
  }

  /// Checks the window with every page and every menu in turn.
  static void expectVisibleEverywhere(OpenWindow& open, const char* when) {
    open->pageTabs().first()->setFocus();
    for (const QAction* top : open->menuBar()->actions()) emit top->menu()->aboutToShow();
    for (QTabWidget* tabs : open->findChildren<QTabWidget*>())
      for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        QCoreApplication::processEvents();
      }
    for (QMenu* menu : open->findChildren<QMenu*>()) emit menu->aboutToShow();
    expectAllVisible(*open.window, QString::fromUtf8(when));
  }

  const QTemporaryDir folder;
  const std::string all = test::allHostileTexts();
};

TEST_F(HostileTextsTest, AreTextInEveryPartOfTheWindow) {
  OpenWindow open;
  load(open, file("all.alidade", hostilePaperText(all)));
  expectVisibleEverywhere(open, "fitted");
  load(open, file("broken.alidade", brokenPaperText(all)));
  expectVisibleEverywhere(open, "nothing of it usable");
  auto* title = open->findChild<QLineEdit*>(QStringLiteral("title"));
  EXPECT_THAT(title->text().toStdString(), StartsWith("a\\u001b[2J\\u001b[Hb"));
  EXPECT_THAT(title->toolTip().toStdString(), StartsWith("a\\u001b[2J\\u001b[Hb"));
}

TEST_F(HostileTextsTest, AreTextInTheNameOfAFile) {
  OpenWindow open;
  open.dialogs->discardOther = true;
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  open.dialogs->onImport = [](ImportPage& page) {
    expectAllVisible(page, QStringLiteral("page of an import"));
  };
  for (const test::HostileText& hostile : test::hostileTexts) {
    const std::string name(hostile.text);
    ASSERT_TRUE(open->files().open(file(name, writeSession(paperSession()))));
    EXPECT_FALSE(test::firstForbidden(open->windowTitle().toStdString(), "")) << hostile.what;
    ASSERT_TRUE(open->files().save());
    EXPECT_FALSE(test::firstForbidden(open->statusBar()->currentMessage().toStdString(), ""));
    EXPECT_FALSE(open->files().open(file("not a session " + name, all)));
    EXPECT_FALSE(open->files().open(file("no readings " + name + ".csv", all)));
    EXPECT_TRUE(open->files().open(file("r " + name + ".csv", "axis;horizontal;vertical\n0;10;90\n")));
    expectAllVisible(*open.window, QString::fromUtf8(hostile.what));
    open->undo();
    EXPECT_FALSE(open->files().open(folder.filePath(of("missing " + name))));
  }
  EXPECT_GE(open.dialogs->problems.size(), 2 * static_cast<qsizetype>(test::hostileTexts.size()));
  EXPECT_GE(open.dialogs->importsAsked, 2 * static_cast<int>(test::hostileTexts.size()));
  for (const QString& problem : open.dialogs->problems)
    EXPECT_FALSE(test::firstForbidden(problem.toStdString())) << problem.toStdString();
}

TEST_F(HostileTextsTest, OfTheTitleBarAreNotTakenForTheSignOfChanges) {
  OpenWindow open;
  load(open, file("plan[*].alidade", writeSession(paperSession())));
  EXPECT_TRUE(open->windowTitle().startsWith(QStringLiteral("plan[*][*].alidade[*] — ")));
}

TEST_F(HostileTextsTest, OfRecentFilesShowTheirAmpersandsAndStillOpen) {
  OpenWindow open;
  RecentFiles::clear();
  const QString path = file("a & b\u202E\n<b>.alidade", hostilePaperText("found again"));
  RecentFiles::add(path);
  QMenu* recent = nullptr;
  for (QMenu* menu : open->findChildren<QMenu*>())
    if (menu->title().contains(QStringLiteral("Recent"))) recent = menu;
  ASSERT_TRUE(recent);
  emit recent->aboutToShow();
  QAction* entry = recent->actions().first();
  EXPECT_THAT(entry->text().toStdString(), HasSubstr("a && b\\u202e\\u000a<b>.alidade"));
  entry->trigger();
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session().title, "found again");
}

TEST_F(HostileTextsTest, OfAPointAreTextInTheMenuOfUndo) {
  OpenWindow open;
  Json json = Json::parse(writeSession(paperSession()));
  json["positions"][0]["readings"][0]["point"] = "a & \u202E\t" + std::string(1000, 'x');
  load(open, file("points.alidade", json.dump()));
  ReadingsEditor(open->document(), 0).setCell({0, ReadingColumn::Note}, "n");
  open.waitUntilIdle();
  QString undo;
  for (const QAction* action : open->menuBar()->actions()[1]->menu()->actions())
    if (action->text().startsWith(QStringLiteral("&Undo"))) undo = action->text();
  EXPECT_THAT(undo.toStdString(), HasSubstr("a && \\u202e\\u0009xx"));
  EXPECT_LT(undo.size(), 100);
}

TEST_F(HostileTextsTest, AreKeptAsTheyWere) {
  OpenWindow open;
  const std::string text = "a\u00A0b\x1b\u202E\n\t\u2028c" + all;
  load(open, file("kept.alidade", hostilePaperText(text)));
  for (FieldEdit* edit : open->findChildren<FieldEdit*>()) {
    edit->setFocus();
    QCoreApplication::processEvents();
  }
  auto* notes = open->findChild<FieldNotes*>();
  notes->setFocus();
  EXPECT_EQ(notes->document()->toRawText().left(5).toStdString(), "a\u00A0b\x1b\u202E")
      << "as typed while edited";
  open->pageTabs().first()->setFocus();
  EXPECT_FALSE(open->document().isModified());
  const QString saved = folder.filePath(QStringLiteral("saved.alidade"));
  open.dialogs->savePath = saved;
  ASSERT_TRUE(open->files().saveAs());
  EXPECT_EQ(writeSession(*loadSession(saved.toStdString())),
            writeSession(*readSession(hostilePaperText(text))));
}

TEST_F(HostileTextsTest, OfEntriesAreEditedAsTheyWereTyped) {
  OpenWindow open;
  load(open, file("edited.alidade", hostilePaperText("a\u202Eb\u00A0c")));
  auto* forms = open->findChild<QTabWidget*>(QStringLiteral("forms"));
  forms->setCurrentIndex(2);
  auto* title = open->findChild<QLineEdit*>(QStringLiteral("title"));
  EXPECT_EQ(title->text().toStdString(), "a\\u202eb\u00A0c");
  title->setFocus();
  EXPECT_EQ(title->text().toStdString(), "a\u202Eb\u00A0c");
  title->end(false);
  QTest::keyClicks(title, QStringLiteral("d"));
  auto* notes = open->findChild<FieldNotes*>();
  notes->setFocus();
  EXPECT_EQ(title->text().toStdString(), "a\\u202eb\u00A0cd");
  EXPECT_EQ(open->document().session().title, "a\u202Eb\u00A0cd");
  QTest::keyClicks(notes, QStringLiteral("e"));
  title->setFocus();
  EXPECT_EQ(open->document().session().notes, "ea\u202Eb\u00A0c");
  EXPECT_EQ(notes->toPlainText().toStdString(), "ea\\u202eb c");
}

TEST_F(HostileTextsTest, KeepTheirEndHoweverLong) {
  OpenWindow open;
  const std::string text(40000, 'x');
  load(open, file("long.alidade", hostilePaperText(text)));
  open->findChild<QTabWidget*>(QStringLiteral("forms"))->setCurrentIndex(2);
  auto* title = open->findChild<QLineEdit*>(QStringLiteral("title"));
  title->setFocus();
  QTest::keyClick(title, Qt::Key_Home);
  QTest::keyClicks(title, QStringLiteral("y"));
  QTest::keyClick(title, Qt::Key_Return);
  EXPECT_EQ(open->document().session().title, "y" + text);
}

/// The texts of one of the program's message boxes while it is open.
std::vector<ShownText> boxTexts(const std::function<void()>& ask) {
  std::vector<ShownText> texts;
  QTimer::singleShot(0, [&texts] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_TRUE(box);
    expectAllVisible(*box, QStringLiteral("message box"));
    texts = shownTexts(*box);
    box->reject();
  });
  ask();
  return texts;
}

TEST_F(HostileTextsTest, AreTextInMessageBoxes) {
  Dialogs dialogs;
  const QString name = of("<b>a</b><img src=\"x.png\">\u202E\n\x1b");
  const std::function<void()> asks[] = {
      [&] { dialogs.askLeave({.name = name}); }, [&] { dialogs.askDiscardOther(name, Dialogs::Way::Undo); },
      [&] { dialogs.showProblem(QStringLiteral("Title"), name + QStringLiteral("\n\n") + of(all)); }};
  for (const auto& ask : asks) {
    bool said = false;
    for (const ShownText& shown : boxTexts(ask))
      said = said || shown.text.contains(QStringLiteral("<b>a</b><img src=\"x.png\">\\u202e"));
    EXPECT_TRUE(said);
  }
  for (const auto& ask : {std::function<void()>([&] { dialogs.showAbout(); }),
                          std::function<void()>([&] { dialogs.showShortcuts(); })}) {
    for (const ShownText& shown : boxTexts(ask)) EXPECT_THAT(shown.text.toStdString(), Not(HasSubstr("<td")));
  }
}

TEST_F(HostileTextsTest, AreTextInToolTips) {
  const QString markup = QStringLiteral("<b>a</b><img src=\"x.png\">");
  ASSERT_TRUE(Qt::mightBeRichText(markup));
  QWidget window;
  window.show();
  QToolTip::showText({0, 0}, markup, &window);
  const QLabel* tip = nullptr;
  for (QWidget* widget : QApplication::topLevelWidgets())
    if (widget->inherits("QTipLabel")) tip = qobject_cast<QLabel*>(widget);
  ASSERT_TRUE(tip);
  EXPECT_EQ(tip->text(), markup);
  EXPECT_EQ(tip->textFormat(), Qt::PlainText);
  QToolTip::hideText();
}

TEST_F(HostileTextsTest, AreTextInTheReport) {
  const std::string text = "<b>\x1b\u202E&amp;";
  const char* shown = "<b>\\u001b\\u202e&amp;";
  const Session session = *readSession(hostilePaperText(text));
  const Printed report(session, {.fileName = of("f\u202E<i>\n.alidade"), .sha256 = {}, .saved = false});
  EXPECT_EQ(test::firstForbidden(report.text().toStdString()), std::nullopt);
  const QString entries = report.page(0);
  EXPECT_GE(entries.count(QString::fromUtf8(shown)), 5) << "title, head, device, operator, place";
  EXPECT_TRUE(report.contains("f\\u202e<i>\\u000a.alidade"));
  EXPECT_GE(report.text().count(QString::fromUtf8(shown)), 34) << "a note for every row";
  const std::string facts = report.tool(QStringLiteral("pdfinfo")).toStdString();
  EXPECT_THAT(facts, HasSubstr(std::string("Title:           Acceptance report: ") + shown));
  EXPECT_EQ(test::firstForbidden(facts), std::nullopt);
}

TEST_F(HostileTextsTest, OfAnyKindLeaveAReportThatIsText) {
  const Printed fitted(*readSession(hostilePaperText(all))), broken(*readSession(brokenPaperText(all)));
  EXPECT_EQ(test::firstForbidden(fitted.text().toStdString()), std::nullopt);
  EXPECT_EQ(test::firstForbidden(broken.text().toStdString()), std::nullopt);
}

// Every line of a note and a name as long as pages are printed complete or shortened with an ellipsis.
TEST_F(HostileTextsTest, OfTenThousandCharactersStayOnTheSheet) {
  std::string note;
  for (int i = 0; i < 2000; ++i) note += std::to_string(10000 + i) + " ";
  Json json = Json::parse(brokenPaperText(std::string(10000, 'M')));
  for (Json& position : json["positions"])
    for (Json& reading : position["readings"]) reading["note"] = "";
  json["positions"][0]["readings"][5]["note"] = note;
  json["notes"] = note;
  const Printed report(*readSession(json.dump()));
  const QStringList words = report.text().split(QRegularExpression(QStringLiteral("[\\s,;]+")));
  for (const int number : {10000, 10500, 11000, 11500, 11999})
    EXPECT_EQ(words.count(QString::number(number)), 2) << number;
  EXPECT_LT(report.pageCount(), 20);
}

TEST_F(HostileTextsTest, AreTextOnTheTerminal) {
  const auto run = [](const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral(ALIDADE_PROGRAM), arguments);
    EXPECT_TRUE(program.waitForFinished());
    EXPECT_EQ(program.exitCode(), 2);
    const std::string errors = program.readAllStandardError().toStdString();
    EXPECT_EQ(test::firstForbidden(errors), std::nullopt) << testing::PrintToString(errors);
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1);
  };
  const QString report = QStringLiteral("--report"), out = folder.filePath(QStringLiteral("r.pdf"));
  run({QStringLiteral("--") + of(all)});
  run({report, out, QStringLiteral("/no/") + of(all)});
  run({report, out, file(std::string(test::hostileTexts[0].text) + ".alidade", all)});
  run({report, out, file("broken.alidade", brokenPaperText(all))});
  run({report, folder.filePath(QStringLiteral("no\x1b/") + of("\u202E\n.pdf")),
       samplePath(QStringLiteral("paper-table-1.alidade"))});
}

}  // namespace
}  // namespace alidade::ui
