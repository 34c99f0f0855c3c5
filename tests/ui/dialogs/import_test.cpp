#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QRadioButton>
#include <QTemporaryDir>
#include <QTest>

#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/import/import_page.h"
#include "ui/main_window.h"
#include "ui/panels/readings/readings_table.h"

// File ▸ Import Readings is undoable. It adds readings to the current session if the session has none; on
// request, it creates a new session. Page tests: import_page_test.cpp.

namespace alidade::ui {
namespace {

using testing::HasSubstr;

class ImportFlow : public ::testing::Test {
 protected:
  /// A session with readings is replaced by a new one.
  ImportFlow() {
    open.dialogs->onImport = [](ImportPage& page) {
      page.findChild<QRadioButton*>(QStringLiteral("import replace"))->click();
    };
  }

  QString file(const QString& name, const QByteArray& content) const {
    const QString path = folder.filePath(name);
    QFile out(path);
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(content);
    return path;
  }
  std::string notes() const { return open.dialogs->problems.join(QLatin1Char('\n')).toStdString(); }

  /// Undoes the typed text and the import. The session then equals its file, but redo would restore the
  /// import.
  void undoWhatWasTypedAndTheImport() {
    typeInto(*open->findChild<QLineEdit*>(QStringLiteral("geometry.distance_mm")), QStringLiteral("2411"));
    open->undo();
    open->undo();
    EXPECT_FALSE(open->document().isModified());
    EXPECT_FALSE(open->close());
    EXPECT_FALSE(open->files().startNew());
  }

  QTemporaryDir folder;
  OpenWindow open;
};

const QByteArray table =
    "axis,point,Hz,V\n0,zero,332°32'54\",89°59'57\"\n0,1,341°52'24\",88°16'49\"\n0,2,341°26'01\",86°41'"
    "24\"\n";

TEST_F(ImportFlow, PutsReadingsIntoASessionWithoutAny) {
  typeInto(*open->findChild<QLineEdit*>(QStringLiteral("geometry.distance_mm")), QStringLiteral("2405"));
  open.dialogs->importPath = file(QStringLiteral("arc.csv"), table);
  EXPECT_TRUE(open->files().importReadings());
  open.waitUntilIdle();
  const Session& session = open->document().session();
  EXPECT_EQ(session.geometry.distanceMm, "2405") << "what was typed stays";
  ASSERT_EQ(session.positions.size(), 1u);
  EXPECT_EQ(session.positions[0].readings.size(), 2u);
  EXPECT_EQ(session.positions[0].zero.horizontal, "332°32'54\"");
  EXPECT_EQ(session.title, "arc");
  EXPECT_TRUE(open->document().isModified());
  EXPECT_TRUE(open.dialogs->problems.isEmpty()) << notes();
  open->undo();
  EXPECT_EQ(session.positions.size(), 2u);
  EXPECT_TRUE(session.positions[0].readings.empty());
  EXPECT_EQ(session.geometry.distanceMm, "2405");
  open->redo();
  EXPECT_EQ(session.positions[0].readings.size(), 2u);
}

TEST_F(ImportFlow, BeginsANewSessionBesideReadings) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  EXPECT_TRUE(open->files().open(file(QStringLiteral("ARC.CSV"), table)));
  EXPECT_EQ(open->document().path(), QString());
  EXPECT_EQ(open->document().session().geometry.distanceMm, "");
  EXPECT_TRUE(open->document().isModified());
  EXPECT_EQ(open.dialogs->saveQuestions, 0);

  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Cancel;
  EXPECT_FALSE(open->files().open(file(QStringLiteral("next.csv"), table))) << "the import is not saved yet";
  EXPECT_EQ(open.dialogs->saveQuestions, 1);
  EXPECT_EQ(open->document().session().title, "ARC");
}

TEST_F(ImportFlow, UndoneLeadsBackToTheSessionBefore) {
  const QString paper = samplePath(QStringLiteral("paper-table-1.alidade"));
  ASSERT_TRUE(open->files().open(paper));
  const Session before = open->document().session();
  typeInto(*open->findChild<QLineEdit*>(QStringLiteral("geometry.distance_mm")), QStringLiteral("2400"));
  const Session edited = open->document().session();
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  open.dialogs->importPath = file(QStringLiteral("arc.csv"), table);
  QTest::keyClick(open.window.get(), Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(open.dialogs->saveQuestions, 1);
  const Session imported = open->document().session();
  EXPECT_EQ(imported.title, "arc");

  ASSERT_TRUE(QTest::qWaitForWindowActive(open.window.get()));
  const auto undo = [&] { QTest::keyClick(open.window.get(), Qt::Key_Z, Qt::ControlModifier); };
  undo();
  open.waitUntilIdle();
  EXPECT_EQ(open->document().session(), edited) << "what was put aside unsaved is back";
  EXPECT_EQ(open->document().path(), QFileInfo(paper).absoluteFilePath());
  EXPECT_TRUE(open->windowTitle().startsWith(QStringLiteral("paper-table-1.alidade")));
  EXPECT_TRUE(open->document().isModified());
  EXPECT_EQ(
      open->currentTable()->model()->index(0, static_cast<int>(ReadingColumn::Horizontal)).data().toString(),
      QStringLiteral("341°52′24″"));
  undo();
  EXPECT_EQ(open->document().session(), before);
  EXPECT_FALSE(open->document().isModified()) << "as in its file";
  open->redo();
  open->redo();
  EXPECT_EQ(open->document().session(), imported);
  EXPECT_EQ(open->document().path(), QString());
}

TEST_F(ImportFlow, KeepsEachSessionInItsFile) {
  const QString first = folder.filePath(QStringLiteral("first.alidade")),
                second = folder.filePath(QStringLiteral("second.alidade"));
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ASSERT_FALSE(open->document().save(first));
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  ASSERT_FALSE(open->document().save(second));
  EXPECT_FALSE(open->document().isModified());
  open->undo();
  EXPECT_EQ(open->document().path(), QFileInfo(first).absoluteFilePath());
  open->redo();
  EXPECT_EQ(open->document().path(), QFileInfo(second).absoluteFilePath());
  EXPECT_FALSE(open->document().isModified());
  open->undo();
  EXPECT_FALSE(open->document().isModified()) << "each is as in its own file";
  EXPECT_FALSE(open->isWindowModified());
  changeField(open->document(), {.field = "operator"}, "M. Ruiz");
  EXPECT_TRUE(open->isWindowModified());
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Save;
  EXPECT_TRUE(open->files().startNew());
  EXPECT_EQ(loadSession(first.toStdString())->title, "Table I");
  EXPECT_EQ(loadSession(second.toStdString())->title, "arc") << "the other one's file is not written over";
}

TEST_F(ImportFlow, UndoneIsNotLeftWithoutAsking) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  undoWhatWasTypedAndTheImport();
  EXPECT_FALSE(open->files().importReadings({file(QStringLiteral("next.csv"), table)}));
  EXPECT_EQ(open.dialogs->othersAsked.count(QStringLiteral("redo to ")), 3);
  open->redo();
  open->redo();
  EXPECT_EQ(open->document().session().geometry.distanceMm, "2411");

  ASSERT_FALSE(open->document().save(folder.filePath(QStringLiteral("arc.alidade"))));
  open->undo();
  open->undo();
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  EXPECT_TRUE(open->files().mayLeave());
  EXPECT_EQ(open.dialogs->othersAsked.size(), 3) << "it is in a file";
}

TEST_F(ImportFlow, UndoneIsNotLeftWithWhatWasTypedAfterItWasSaved) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  ASSERT_FALSE(open->document().save(folder.filePath(QStringLiteral("arc.alidade"))));
  undoWhatWasTypedAndTheImport();
  EXPECT_FALSE(open->files().open(samplePath(QStringLiteral("clean-session.alidade"))));
  EXPECT_EQ(open.dialogs->othersAsked, QStringList(3, QStringLiteral("redo to arc.alidade")));
  EXPECT_EQ(open.dialogs->saveQuestions, 0);
  open->redo();
  open->redo();
  EXPECT_EQ(open->document().session().geometry.distanceMm, "2411");
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Save;
  EXPECT_TRUE(open->files().startNew());
  EXPECT_EQ(open.dialogs->othersAsked.size(), 3) << "all is in its file";
}

TEST_F(ImportFlow, UndoneIsNotDroppedByTheNextImport) {
  changeField(open->document(), {.field = "title"}, "Begun");
  ReadingsEditor(open->document(), 0).setCell({0, ReadingColumn::Horizontal}, "341 52 24");
  open.dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  changeField(open->document(), {.field = "geometry.distance_mm"}, "2411");
  for (int i = 0; i < 3; ++i) open->undo();
  EXPECT_FALSE(open->files().importReadings({file(QStringLiteral("next.csv"), table)}))
      << "there are no readings yet, so nothing else is put aside";
  EXPECT_EQ(open.dialogs->othersAsked, QStringList(QStringLiteral("redo to ")));
  for (int i = 0; i < 3; ++i) open->redo();
  EXPECT_EQ(open->document().session().geometry.distanceMm, "2411");
}

TEST_F(ImportFlow, SavedOverTheFileOfTheSessionBeforeLeavesThatInNone) {
  const QString path = folder.filePath(QStringLiteral("first.alidade"));
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ASSERT_FALSE(open->document().save(path));
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  ASSERT_FALSE(open->document().save(folder.filePath(QStringLiteral("./first.alidade"))));
  open->undo();
  EXPECT_TRUE(open->document().isModified());
  EXPECT_EQ(open->document().path(), QString()) << "Save asks for another file";
  open->redo();
  EXPECT_FALSE(open->document().isModified());
  EXPECT_TRUE(open->files().startNew()) << "to write over it was wanted";
}

TEST_F(ImportFlow, UndoneIsLeftWhereThatIsWanted) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  ASSERT_TRUE(open->files().importReadings({file(QStringLiteral("arc.csv"), table)}));
  open->undo();
  open.dialogs->discardOther = true;
  EXPECT_TRUE(open->files().startNew());
  EXPECT_EQ(open.dialogs->othersAsked.size(), 1);
  EXPECT_TRUE(open->files().startNew());
  EXPECT_EQ(open.dialogs->othersAsked.size(), 1) << "nothing is left to redo";
}

TEST_F(ImportFlow, LeavesTheSessionWhereNothingCanBeRead) {
  ASSERT_TRUE(open->files().open(samplePath(QStringLiteral("paper-table-1.alidade"))));
  EXPECT_FALSE(open->files().open(file(QStringLiteral("empty.csv"), "# nothing\n")));
  EXPECT_FALSE(open->files().open(folder.filePath(QStringLiteral("missing.gsi"))));
  EXPECT_THAT(notes(), HasSubstr("“empty.csv” cannot be imported."));
  EXPECT_THAT(notes(), HasSubstr("cannot be opened"));
  EXPECT_EQ(open.dialogs->importsAsked, 0);
  EXPECT_EQ(open->document().session().title, "Table I");
}

}  // namespace
}  // namespace alidade::ui
