#include "ui/dialogs/changed_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <QApplication>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <csignal>
#include <filesystem>

#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/main_window.h"
#include "ui/panels/window/changed_file_bar.h"

// A session's file that other programs write or have open, or that is not writable.

namespace alidade::ui {
namespace {

using ::testing::HasSubstr;

class ChangedFileTest : public ::testing::Test {
 protected:
  ChangedFileTest() {
    QFile::copy(samplePath(QStringLiteral("paper-table-1.alidade")), file);
    QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
  }

  QString in(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  std::string bytes() const { return *readFile(file.toStdString()); }

  void put(const std::string& text) const {
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(QByteArray::fromStdString(text));
  }
  /// Writes as another program would; returns the bytes.
  std::string writeAsOther(const char* notes) const {
    Session session = *readSession(bytes());
    session.notes = notes;
    put(writeSession(session));
    return bytes();
  }
  void open(OpenWindow& window, const char* title = "mine") const {
    ASSERT_TRUE(window->files().open(file));
    if (title) changeField(window->document(), {.field = "title"}, title);
  }

  QTemporaryDir folder;
  QString file = folder.filePath(QStringLiteral("s.alidade"));
};

/// The answer to a question by a key, pressed once the dialog is active.
template <typename Ask>
auto answerTo(Ask ask, Qt::Key key) {
  QTimer::singleShot(0, [key] {
    QWidget* dialog = QApplication::activeModalWidget();
    ASSERT_TRUE(dialog);
    QApplication::setActiveWindow(dialog);
    QTest::keyClick(dialog->focusWidget() ? dialog->focusWidget() : dialog, key);
    if (dialog->isVisible()) QTest::keyClick(dialog, Qt::Key_Escape);
  });
  return ask();
}

constexpr Qt::Key answeringKeys[] = {Qt::Key_Return, Qt::Key_Space, Qt::Key_Escape};

TEST(SafeAnswers, AKeyOverwritesNoFile) {
  for (const Qt::Key key : answeringKeys)
    for (const auto& difference : {std::optional<SessionDifference>(), std::optional(SessionDifference())}) {
      const ChangedFile file{QStringLiteral("s.alidade"), difference, QStringLiteral("torn")};
      EXPECT_EQ(answerTo([&] { return askChangedFile(nullptr, file); }, key), ChangedFileAnswer::Cancel)
          << key << difference.has_value();
    }
}

TEST(SafeAnswers, ReturnOverwritesNoFileWhereverTheKeyboardIs) {
  const ChangedFile file{QStringLiteral("s.alidade"), {}, QStringLiteral("torn")};
  QTimer::singleShot(0, [] {
    QWidget* dialog = QApplication::activeModalWidget();
    for (QPushButton* button : dialog->findChildren<QPushButton*>()) {
      EXPECT_EQ(button->isDefault(), button->hasFocus() || dialog->focusWidget() == button);
      EXPECT_TRUE(button->isDefault() || !button->autoDefault());
    }
    QTest::keyClick(dialog, Qt::Key_Return);
  });
  EXPECT_EQ(askChangedFile(nullptr, file), ChangedFileAnswer::Cancel);
}

TEST(SafeAnswers, AKeyDiscardsNothing) {
  Dialogs dialogs;
  for (const Qt::Key key : answeringKeys) {
    for (const Dialogs::Unsaved& unsaved :
         {Dialogs::Unsaved{.name = QStringLiteral("s")},
          Dialogs::Unsaved{.name = QStringLiteral("s"), .isModified = false, .waiting = 2}})
      EXPECT_NE(answerTo([&] { return dialogs.askLeave(unsaved); }, key), Dialogs::SaveAnswer::Discard);
    for (const auto way : {Dialogs::Way::Undo, Dialogs::Way::Redo})
      EXPECT_FALSE(answerTo([&] { return dialogs.askDiscardOther(QStringLiteral("s"), way); }, key));
    EXPECT_FALSE(
        answerTo([&] { return dialogs.askOpenElsewhere(QStringLiteral("s"), QStringLiteral("1")); }, key));
  }
}

TEST(SafeAnswers, AKeyDiscardsNothingThatIsToBeRecovered) {
  for (const Qt::Key key : answeringKeys) {
    const QList<RecoveryOffer> offers{{.name = QStringLiteral("s"), .details = {}, .difference = {}}};
    EXPECT_NE(answerTo([&] { return RecoveryDialog(offers, nullptr).ask(); }, key).choice,
              RecoveryAnswer::Choice::Discard);
  }
}

TEST_F(ChangedFileTest, AsksBeforeItOverwritesWhatOthersWrote) {
  OpenWindow window;
  open(window);
  const std::string theirs = writeAsOther("theirs");
  EXPECT_FALSE(window->files().save());
  EXPECT_EQ(bytes(), theirs) << "cancelled";
  EXPECT_TRUE(window->document().isModified());
  ASSERT_EQ(window.dialogs->changedFiles.size(), 1);
  const ChangedFile& shown = window.dialogs->changedFiles[0];
  EXPECT_EQ(shown.name, QStringLiteral("s.alidade"));
  ASSERT_TRUE(shown.difference);
  ASSERT_EQ(shown.difference->count, 2u);
  EXPECT_EQ(shown.difference->entries[0].where, QStringLiteral("title"));
  EXPECT_EQ(shown.difference->entries[0].mine, QStringLiteral("mine"));
  EXPECT_EQ(shown.difference->entries[1].theirs, QStringLiteral("theirs"));
  window.dialogs->changedFileAnswer = ChangedFileAnswer::Overwrite;
  EXPECT_TRUE(window->files().save());
  EXPECT_EQ(readSession(bytes())->title, "mine");
  changeField(window->document(), {.field = "title"}, "mine again");
  EXPECT_TRUE(window->files().save());
  EXPECT_EQ(window.dialogs->changedFiles.size(), 2) << "not asked about what was written here";
}

TEST_F(ChangedFileTest, ReloadsAndUndoBringsBackWhatWasHere) {
  OpenWindow window;
  open(window);
  writeAsOther("theirs");
  window.dialogs->changedFileAnswer = ChangedFileAnswer::Reload;
  EXPECT_FALSE(window->files().save());
  EXPECT_EQ(window->document().session(), *readSession(bytes()));
  EXPECT_FALSE(window->document().isModified());
  window->undo();
  EXPECT_EQ(window->document().session().title, "mine");
  EXPECT_TRUE(window->document().isModified());
  EXPECT_TRUE(window->files().save()) << "theirs was seen";
  EXPECT_EQ(window.dialogs->changedFiles.size(), 1);
}

TEST_F(ChangedFileTest, SavesElsewhere) {
  OpenWindow window;
  open(window);
  const std::string theirs = writeAsOther("theirs");
  window.dialogs->changedFileAnswer = ChangedFileAnswer::SaveAs;
  window.dialogs->savePath = in("other.alidade");
  EXPECT_TRUE(window->files().save());
  EXPECT_EQ(bytes(), theirs);
  EXPECT_EQ(window->document().path(), in("other.alidade"));
  EXPECT_FALSE(window->document().isModified());
}

TEST_F(ChangedFileTest, DoesNotReloadWhatIsNoSession) {
  OpenWindow window;
  open(window);
  put("torn");
  window.dialogs->changedFileAnswer = ChangedFileAnswer::Reload;
  EXPECT_FALSE(window->files().save());
  EXPECT_FALSE(window.dialogs->changedFiles.at(0).difference);
  EXPECT_THAT(window.dialogs->changedFiles[0].problem.toStdString(), HasSubstr("JSON"));
  EXPECT_EQ(window->document().session().title, "mine");
}

TEST_F(ChangedFileTest, AsksNothingWhereNothingWouldBeLost) {
  OpenWindow window;
  open(window);
  put(writeSession(window->document().session()) + "\n\n");
  EXPECT_TRUE(window->files().save()) << "the same, laid out in another way";
  changeField(window->document(), {.field = "title"}, "again");
  ASSERT_TRUE(QFile::remove(file));
  EXPECT_TRUE(window->files().save()) << "there is nothing to be overwritten";
  EXPECT_EQ(readSession(bytes())->title, "again");
  EXPECT_TRUE(window.dialogs->changedFiles.isEmpty());
}

TEST_F(ChangedFileTest, IsNoticedBeforeAnybodySaves) {
  OpenWindow window;
  open(window, nullptr);
  auto* bar = window->findChild<ChangedFileBar*>();
  ASSERT_TRUE(bar);
  EXPECT_FALSE(bar->isVisible());
  writeAsOther("theirs");
  ASSERT_TRUE(waitFor([&] { return bar->isVisible(); }));
  window.dialogs->changedFileAnswer = ChangedFileAnswer::Reload;
  bar->findChild<QPushButton*>(QStringLiteral("compare with file"))->click();
  EXPECT_EQ(window->document().session().notes, "theirs");
  EXPECT_TRUE(waitFor([&] { return !bar->isVisible(); }));
  // Replaces the file, as careful programs save.
  std::filesystem::copy_file(file.toStdString(), in("fresh").toStdString());
  Session session = *readSession(bytes());
  session.notes = "theirs, too";
  QFile fresh(in("fresh"));
  ASSERT_TRUE(fresh.open(QIODevice::WriteOnly));
  fresh.write(QByteArray::fromStdString(writeSession(session)));
  fresh.close();
  std::filesystem::rename(in("fresh").toStdString(), file.toStdString());
  EXPECT_TRUE(waitFor([&] { return bar->isVisible(); }));
}

TEST_F(ChangedFileTest, IsMissedAndWrittenAgain) {
  OpenWindow window;
  open(window, nullptr);
  auto* bar = window->findChild<ChangedFileBar*>();
  auto* save = bar->findChild<QPushButton*>(QStringLiteral("save missing file"));
  ASSERT_TRUE(QFile::remove(file));
  ASSERT_TRUE(waitFor([&] { return bar->isVisible(); }));
  EXPECT_TRUE(window->document().isModified()) << "it is saved nowhere";
  EXPECT_FALSE(bar->findChild<QPushButton*>(QStringLiteral("compare with file"))->isVisible());
  ASSERT_TRUE(save && save->isVisible());
  save->click();
  EXPECT_EQ(readSession(bytes())->title, window->document().session().title);
  EXPECT_FALSE(window->document().isModified());
  EXPECT_TRUE(waitFor([&] { return !bar->isVisible(); }));
}

TEST_F(ChangedFileTest, IsAskedAboutOnLeavingOnceItIsGone) {
  OpenWindow window;
  open(window, nullptr);
  ASSERT_TRUE(QFile::remove(file));
  EXPECT_FALSE(window->close()) << "also before the watch has noticed";
  EXPECT_EQ(window.dialogs->saveQuestions, 1);
  window.dialogs->saveAnswer = Dialogs::SaveAnswer::Save;
  EXPECT_TRUE(window->close());
  EXPECT_TRUE(QFile::exists(file));
}

TEST_F(ChangedFileTest, IsNotMissedWhileAnotherProgramReplacesIt) {
  OpenWindow window;
  open(window, nullptr);
  auto* bar = window->findChild<ChangedFileBar*>();
  ASSERT_TRUE(QFile::rename(file, in("backup")));
  QTest::qWait(400);  // the watch checks after 150 ms
  ASSERT_TRUE(QFile::rename(in("backup"), file));
  QTest::qWait(2000);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_FALSE(window->document().isModified());
}

TEST_F(ChangedFileTest, IsNotTakenForAnothersWhileItIsSaved) {
  OpenWindow window;
  open(window, nullptr);
  auto* bar = window->findChild<ChangedFileBar*>();
  emit window->files().holding(true);
  writeAsOther("as a long save leaves it, before the window knows");
  QTest::qWait(500);  // the watch checks after 150 ms
  EXPECT_FALSE(bar->isVisible());
  emit window->files().holding(false);
  EXPECT_TRUE(waitFor([&] { return bar->isVisible(); })) << "it was another's";
  window.dialogs->changedFileAnswer = ChangedFileAnswer::Overwrite;
  EXPECT_TRUE(window->files().save());
  EXPECT_TRUE(waitFor([&] { return !bar->isVisible(); })) << "looked at again afterwards";
}

TEST_F(ChangedFileTest, TwoWindowsKnowOfEachOther) {
  OpenWindow first, second;
  for (OpenWindow* window : {&first, &second}) (*window)->keepIn(in("kept"));
  open(first);
  EXPECT_FALSE(second->files().open(file));
  EXPECT_EQ(second.dialogs->elsewhere, QStringList(QStringLiteral("s.alidade")));
  EXPECT_EQ(second->document().path(), QString());
  second.dialogs->goOn = true;
  open(second, "of the second");
  ASSERT_TRUE(first->files().save());
  EXPECT_FALSE(second->files().save()) << "the first's would be overwritten";
  EXPECT_EQ(second.dialogs->changedFiles.size(), 1);
  second.dialogs->changedFileAnswer = ChangedFileAnswer::Overwrite;
  EXPECT_TRUE(second->files().save());
  changeField(first->document(), {.field = "title"}, "again");
  EXPECT_FALSE(first->files().save());
  EXPECT_EQ(readSession(bytes())->title, "of the second");
  // Saving another session over an open file is also refused.
  OpenWindow third;
  third->keepIn(in("kept"));
  third.dialogs->savePath = file;
  EXPECT_FALSE(third->files().saveAs());
  EXPECT_EQ(third.dialogs->elsewhere.size(), 1);
}

TEST_F(ChangedFileTest, StaysWholeWhereTheDiskIsFull) {
  OpenWindow window;
  open(window);
  const std::string before = bytes();
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small = {.rlim_cur = 1000, .rlim_max = limit.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const bool isSaved = window->files().save();
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(isSaved);
  EXPECT_EQ(bytes(), before);
  EXPECT_TRUE(window->document().isModified());
  EXPECT_THAT(window.dialogs->problems.value(0).toStdString(), HasSubstr("s.alidade cannot be written: "));
  EXPECT_TRUE(window->files().save()) << "the disk has room again";
}

TEST_F(ChangedFileTest, IsReplacedBehindItsLink) {
  ASSERT_TRUE(QFile::link(file, in("link.alidade")));
  OpenWindow window;
  ASSERT_TRUE(window->files().open(in("link.alidade")));
  changeField(window->document(), {.field = "title"}, "mine");
  ASSERT_TRUE(window->files().save());
  EXPECT_TRUE(QFileInfo(in("link.alidade")).isSymLink());
  EXPECT_EQ(readSession(bytes())->title, "mine");
}

TEST_F(ChangedFileTest, IsNeverReplacedByItsReport) {
  OpenWindow window;
  open(window, nullptr);
  const std::string before = bytes();
  ASSERT_TRUE(QFile::link(file, in("link.pdf")));
  for (const QString& path : {file, in("link.pdf")}) {
    window.dialogs->reportPath = path;
    EXPECT_FALSE(window->files().exportReport());
    EXPECT_THAT(window.dialogs->problems.takeLast().toStdString(), HasSubstr("the file being read"));
  }
  EXPECT_EQ(bytes(), before);
}

// Reading a pipe without an end would block the window.
TEST_F(ChangedFileTest, PipesAndDevicesAreNotOpened) {
  OpenWindow window;
  open(window, nullptr);
  const Session before = window->document().session();
  ASSERT_EQ(mkfifo(in("pipe.alidade").toLocal8Bit().constData(), 0600), 0);
  ASSERT_EQ(mkfifo(in("pipe.csv").toLocal8Bit().constData(), 0600), 0);
  for (const QString& path :
       {in("pipe.alidade"), in("pipe.csv"), QStringLiteral("/dev/zero"), folder.path()}) {
    EXPECT_FALSE(window->files().open(path));
    EXPECT_THAT(window.dialogs->problems.takeLast().toStdString(), HasSubstr(": choose a file."));
  }
  window.dialogs->reportPath = window.dialogs->savePath = in("pipe.alidade");
  EXPECT_FALSE(window->files().saveAs());
  EXPECT_FALSE(window->files().exportReport());
  EXPECT_EQ(window.dialogs->problems.size(), 2);
  EXPECT_EQ(window->document().session(), before);
}

}  // namespace
}  // namespace alidade::ui
