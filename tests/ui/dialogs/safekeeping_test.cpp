#include "ui/dialogs/safekeeping.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/base/atomic_file.h"
#include "core/base/file_bytes.h"
#include "core/session/protocol_progress.h"
#include "core/session/session_file.h"
#include "core/simulation/protocol.h"
#include "tests/ui/support.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/main_window.h"

// Unsaved changes of a crashed window, and their recovery by the next one. A window destroyed without closing
// represents a crash.

namespace alidade::ui {
namespace {

using ::testing::HasSubstr;
using Choice = RecoveryAnswer::Choice;

class SafekeepingTest : public ::testing::Test {
 protected:
  SafekeepingTest() {
    QFile::copy(samplePath(QStringLiteral("paper-table-1.alidade")), file);
    QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
  }

  QStringList records() const { return QDir(kept).entryList({QStringLiteral("*.unsaved")}); }
  Session sessionIn(const QString& path) const { return *loadSession(path.toStdString()); }

  std::unique_ptr<OpenWindow> openWindow(const QString& path = {}) const {
    auto open = std::make_unique<OpenWindow>();
    open->window->keepIn(kept);
    EXPECT_TRUE(path.isEmpty() || open->window->files().open(path));
    return open;
  }

  void edit(OpenWindow& open, const char* title) const {
    changeField(open->document(), {.field = "title"}, title);
  }

  /// A crash with this title unsaved, and a complete record.
  void crash(const QString& path, const char* title) const {
    const qsizetype before = records().size();
    const auto open = openWindow(path);
    edit(*open, title);
    EXPECT_TRUE(waitFor([&] { return records().size() == before + 1; }));
  }

  QTemporaryDir folder;
  QString file = folder.filePath(QStringLiteral("s.alidade")), kept = folder.filePath(QStringLiteral("kept"));
};

TEST_F(SafekeepingTest, KeepsAnEditWithinASecond) {
  const auto open = openWindow(file);
  EXPECT_TRUE(records().isEmpty());
  QElapsedTimer clock;
  clock.start();
  edit(*open, "kept");
  ASSERT_TRUE(waitFor([&] { return !records().isEmpty(); }));
  EXPECT_LT(clock.elapsed(), 1000);
  const auto newest = [&] {
    return *readRecovery(*readFile(kept.toStdString() + '/' + records()[0].toStdString()));
  };
  EXPECT_EQ(newest().session.title, "kept");
  EXPECT_EQ(newest().path, file);
  // Continuous edits are kept as well.
  clock.restart();
  int number = 0;
  while (newest().session.title == "kept" && clock.elapsed() < 3000) {
    edit(*open, std::to_string(++number).c_str());
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  EXPECT_LT(clock.elapsed(), 1000);
  EXPECT_EQ(sessionIn(file).title, "Table I");
}

TEST_F(SafekeepingTest, NeedsNoRecordOfWhatIsSaved) {
  const auto open = openWindow(file);
  edit(*open, "kept");
  ASSERT_TRUE(waitFor([&] { return !records().isEmpty(); }));
  (*open)->undo();
  EXPECT_TRUE(waitFor([&] { return records().isEmpty(); })) << "undone, it is as in the file";
  (*open)->redo();
  ASSERT_TRUE(waitFor([&] { return !records().isEmpty(); }));
  ASSERT_TRUE((*open)->files().save());
  EXPECT_TRUE(waitFor([&] { return records().isEmpty(); }));
  edit(*open, "again");
  ASSERT_TRUE(waitFor([&] { return !records().isEmpty(); }));
  open->dialogs->saveAnswer = Dialogs::SaveAnswer::Discard;
  EXPECT_TRUE((*open)->close());
  EXPECT_TRUE(records().isEmpty()) << "discarded by the user's own word";
}

TEST_F(SafekeepingTest, OffersWhatACrashLeftBehindBesideTheFile) {
  crash(file, "unsaved");
  const auto open = openWindow();
  open->dialogs->recoveries = {{Choice::Recover, 0}};
  EXPECT_TRUE((*open)->offerRecovery());
  ASSERT_EQ(open->dialogs->offers.size(), 1u);
  const RecoveryOffer& offer = open->dialogs->offers[0].at(0);
  EXPECT_EQ(offer.name, QStringLiteral("s.alidade"));
  EXPECT_THAT(offer.details.toStdString(), HasSubstr("in " + file.toStdString() + "; kept on "));
  ASSERT_EQ(offer.difference.count, 1u);
  EXPECT_EQ(offer.difference.entries[0].where, QStringLiteral("title"));
  EXPECT_EQ(offer.difference.entries[0].mine, QStringLiteral("unsaved"));
  EXPECT_EQ(offer.difference.entries[0].theirs, QStringLiteral("Table I"));
  EXPECT_EQ((*open)->document().session().title, "unsaved");
  EXPECT_EQ((*open)->document().path(), file);
  EXPECT_TRUE((*open)->document().isModified());
  EXPECT_EQ(sessionIn(file).title, "Table I") << "the file is as it was";
  EXPECT_EQ(records().size(), 1) << "and there is a record at every moment";
  (*open)->undo();
  EXPECT_EQ((*open)->document().session(), sessionIn(file));
  (*open)->redo();
  EXPECT_TRUE((*open)->files().save());
  EXPECT_EQ(sessionIn(file).title, "unsaved");
  EXPECT_TRUE(waitFor([&] { return records().isEmpty(); }));
}

/// What was in the file before the crash is recorded: its change enters the journal, as without the crash.
TEST_F(SafekeepingTest, RecoveredEntriesAreRecordedAsInTheirFile) {
  crash(file, "unsaved");
  const auto open = openWindow();
  open->dialogs->recoveries = {{Choice::Recover, 0}};
  ASSERT_TRUE((*open)->offerRecovery());
  const std::string distance = sessionIn(file).geometry.distanceMm;
  changeField((*open)->document(), {.field = "geometry.distance_mm"}, "2410");
  ASSERT_TRUE((*open)->files().save());
  const std::vector<JournalEntry> journal = sessionIn(file).journal;
  ASSERT_EQ(journal.size(), 1u);
  EXPECT_EQ(journal[0].from, distance);
  EXPECT_EQ(journal[0].to, "2410");
}

TEST_F(SafekeepingTest, AFormThatWasNeverSavedIsStillFilledInAfterACrash) {
  crash({}, "first");
  const auto open = openWindow();
  open->dialogs->recoveries = {{Choice::Recover, 0}};
  ASSERT_TRUE((*open)->offerRecovery());
  for (const char* typed : {"2410", "2406"})
    changeField((*open)->document(), {.field = "geometry.distance_mm"}, typed);
  EXPECT_TRUE((*open)->document().session().journal.empty());
}

TEST_F(SafekeepingTest, OffersASessionThatIsInNoFile) {
  crash({}, "first");
  crash({}, "second");
  const auto open = openWindow();
  EXPECT_TRUE((*open)->offerRecovery()) << "put off";
  ASSERT_EQ(open->dialogs->offers.at(0).size(), 2);
  const QString wanted = QStringLiteral("second");
  const int index = open->dialogs->offers[0][0].name == wanted ? 0 : 1;
  EXPECT_EQ(open->dialogs->offers[0][index].name, wanted);
  EXPECT_THAT(open->dialogs->offers[0][index].details.toStdString(), HasSubstr("not saved to a file yet"));
  open->dialogs->recoveries = {{}, {Choice::Recover, index}};
  EXPECT_TRUE((*open)->offerRecovery());
  EXPECT_EQ((*open)->document().session().title, "second");
  EXPECT_EQ((*open)->document().path(), QString());
  EXPECT_TRUE((*open)->document().isModified());
  EXPECT_EQ(records().size(), 2) << "the other stays";
}

TEST_F(SafekeepingTest, OffersAgainWhenTheOpenSessionIsNotLeft) {
  crash({}, "left");
  const auto open = openWindow();
  edit(*open, "typed since");
  open->dialogs->saveAnswer = Dialogs::SaveAnswer::Cancel;
  open->dialogs->recoveries = {{Choice::Recover, 0}, {Choice::Discard, 0}};
  EXPECT_TRUE((*open)->offerRecovery());
  EXPECT_EQ(open->dialogs->saveQuestions, 1);
  EXPECT_EQ(open->dialogs->offers.size(), 2u) << "the user may choose again";
  EXPECT_EQ((*open)->document().session().title, "typed since");
}

TEST_F(SafekeepingTest, DiscardsOnlyWhenTold) {
  crash(file, "one");
  crash({}, "two");
  const auto open = openWindow();
  EXPECT_TRUE((*open)->offerRecovery());
  EXPECT_EQ(records().size(), 2) << "later";
  open->dialogs->offers.clear();
  open->dialogs->recoveries = {{Choice::Discard, 1}, {Choice::Discard, 0}};
  EXPECT_TRUE((*open)->offerRecovery());
  EXPECT_EQ(open->dialogs->offers.size(), 2u);
  EXPECT_TRUE(records().isEmpty());
  EXPECT_FALSE((*open)->offerRecovery());
  EXPECT_FALSE((*open)->document().isModified());
}

TEST_F(SafekeepingTest, DoesNotOfferWhatALivingWindowKeeps) {
  const auto open = openWindow(file);
  edit(*open, "mine");
  ASSERT_TRUE(waitFor([&] { return !records().isEmpty(); }));
  const auto other = openWindow();
  EXPECT_FALSE((*other)->offerRecovery());
}

TEST_F(SafekeepingTest, TellsWhatBecameOfTheFileMeanwhile) {
  crash(file, "unsaved");
  Session changed = sessionIn(file);
  changed.notes = "by another";
  QFile(file).remove();
  const auto offered = [&] {
    const auto open = openWindow();
    (*open)->offerRecovery();
    return open->dialogs->offers.at(0).at(0);
  };
  EXPECT_THAT(offered().details.toStdString(), HasSubstr("which is no longer there"));
  QFile again(file);
  ASSERT_TRUE(again.open(QIODevice::WriteOnly));
  again.write(QByteArray::fromStdString(writeSession(changed)));
  again.close();
  EXPECT_THAT(offered().details.toStdString(),
              HasSubstr("which has changed since Alidade last read or saved it"));
  EXPECT_EQ(offered().difference.count, 2u) << "title and notes";
}

// A record that equals the file is cleared whatever its age, since there is no choice to make.
TEST_F(SafekeepingTest, ClearsAwayWhatIsInTheFileAlready) {
  crash(file, "unsaved");
  Session saved = sessionIn(file);
  saved.title = "unsaved";
  QFile again(file);
  ASSERT_TRUE(again.open(QIODevice::WriteOnly));
  again.write(QByteArray::fromStdString(writeSession(saved)));
  again.close();
  const auto open = openWindow();
  EXPECT_FALSE((*open)->offerRecovery());
  EXPECT_TRUE(records().isEmpty());
}

TEST_F(SafekeepingTest, SaysThatNothingCanBeKept) {
  QFile inTheWay(kept);
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  const auto open = openWindow(file);
  edit(*open, "lost in a crash");
  const auto said = [&] { return (*open)->statusBar()->currentMessage().toStdString(); };
  EXPECT_TRUE(waitFor([&] { return said().find("would be lost in a crash") != std::string::npos; }));
  EXPECT_THAT(said(), HasSubstr("its folder does not exist"));
}

TEST_F(SafekeepingTest, MarksForAsLongAsNothingCanBeKept) {
  QFile inTheWay(kept);
  ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
  inTheWay.close();
  const auto open = openWindow(file);
  const auto* mark = (*open)->findChild<QLabel*>(QStringLiteral("safekeeping trouble"));
  ASSERT_TRUE(mark);
  EXPECT_FALSE(mark->isVisible());
  edit(*open, "lost in a crash");
  ASSERT_TRUE(waitFor([&] { return mark->isVisible(); }));
  (*open)->statusBar()->clearMessage();
  EXPECT_THAT(mark->text().toStdString(), HasSubstr("not kept"));
  EXPECT_THAT(mark->toolTip().toStdString(), HasSubstr("its folder does not exist"));
  ASSERT_TRUE(inTheWay.remove());
  ASSERT_TRUE(QDir().mkpath(kept));
  edit(*open, "kept");
  EXPECT_TRUE(waitFor([&] { return !mark->isVisible(); }));
  EXPECT_EQ(records().size(), 1);
}

/// Records are private, since the session's file may be; their folder belongs to the program.
TEST_F(SafekeepingTest, KeepsRecordsForTheirOwnerAlone) {
  QDir().mkpath(kept);
  constexpr auto everybody = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner | QFile::ReadGroup |
                             QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
  QFile::setPermissions(kept, everybody);
  crash(file, "unsaved");
  constexpr auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup | QFile::ReadOther |
                          QFile::WriteOther | QFile::ExeOther;
  EXPECT_FALSE(QFile::permissions(kept) & others);
  for (const QString& name : records())
    EXPECT_FALSE(QFile::permissions(QDir(kept).filePath(name)) & others) << name.toStdString();
}

TEST_F(SafekeepingTest, LocksOfKilledWindowsDoNotPileUp) {
  QDir().mkpath(kept);
  QFile lock(kept + QStringLiteral("/gone.unsaved.lock"));
  ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
  lock.write("999999999\nalidade\n" + QSysInfo::machineHostName().toUtf8() + '\n');
  lock.close();
  const auto open = openWindow();
  EXPECT_FALSE(lock.exists());
}

/// An entry being typed by key, and where it appears afterwards.
struct HalfTypedCase {
  const char* name;
  Place place;
  const char* keys;
  std::function<std::string(const Session&)> text;
};

class HalfTypedKept : public SafekeepingTest, public ::testing::WithParamInterface<HalfTypedCase> {
 protected:
  /// Types all keys without committing. Returns false if no record of the entry appears within a second.
  bool typeAndCrash(const HalfTypedCase& typed) const {
    const auto open = openWindow(file);
    QApplication::setActiveWindow(open->window.get());
    open->waitUntilIdle();
    (*open)->reveal(typed.place);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    for (const char* key = typed.keys; *key; ++key) QTest::keyClick(QApplication::focusWidget(), *key);
    QElapsedTimer clock;
    clock.start();
    const bool isKept = waitFor([&] {
      const QStringList names = QDir(kept).entryList({QStringLiteral("*.typed")});
      return names.size() == 1 && QFile(QDir(kept).filePath(names[0])).size() > 0;
    });
    return isKept && clock.elapsed() < 1000;
  }
};

TEST_P(HalfTypedKept, IsBackAfterACrash) {
  const Session before = sessionIn(file);
  ASSERT_TRUE(typeAndCrash(GetParam()));
  const auto open = openWindow();
  open->dialogs->recoveries = {{Choice::Recover, 0}};
  ASSERT_TRUE((*open)->offerRecovery());
  EXPECT_GE(open->dialogs->offers[0].at(0).difference.count, 1u);
  EXPECT_EQ(GetParam().text((*open)->document().session()), GetParam().keys);
  EXPECT_TRUE((*open)->document().isModified());
  EXPECT_EQ(sessionIn(file), before);
  (*open)->undo();
  EXPECT_EQ((*open)->document().session(), before) << "one step";
}

INSTANTIATE_TEST_SUITE_P(
    Entries, HalfTypedKept,
    ::testing::Values(
        HalfTypedCase{"Notes",
                      {.field = "notes"},
                      "sixty words, and none handed in",
                      [](const Session& session) { return session.notes; }},
        HalfTypedCase{"Field",
                      {.field = "geometry.distance_mm"},
                      "2406.",
                      [](const Session& session) { return session.geometry.distanceMm; }},
        HalfTypedCase{"PointingZero",
                      {.position = 1, .field = "pointing_zero.vertical"},
                      "89 59",
                      [](const Session& session) { return session.positions[1].zero.vertical; }},
        HalfTypedCase{"Reading",
                      {.position = 1, .reading = 3, .field = "vertical"},
                      "87 5",
                      [](const Session& session) { return session.positions[1].readings[3].vertical; }},
        HalfTypedCase{"NewReading",
                      {.position = 0, .reading = 17, .field = "horizontal"},
                      "323 11 4",
                      [](const Session& session) {
                        const auto& rows = session.positions[0].readings;
                        return rows.size() == 18 ? rows[17].horizontal : std::string("no new row");
                      }},
        HalfTypedCase{"Note",
                      {.position = 0, .reading = 2, .field = "note"},
                      "gust",
                      [](const Session& session) { return session.positions[0].readings[2].note; }}),
    [](const auto& entry) { return std::string(entry.param.name); });

/// The program chose point 12 by its worth; the recovered session has no chosen sighting yet.
TEST_F(SafekeepingTest, AHalfTypedReadingStaysOfTheChosenPlace) {
  Session session = sessionIn(file);
  session.positions[0].readings.resize(4);
  SightingProtocol protocol = *templateNamed("there-and-back");
  protocol.isByWorth = true;
  session.protocol = protocolText(protocol);
  ASSERT_FALSE(writeFile(file.toStdString(), writeSession(session), {}));
  {
    const auto open = openWindow(file);
    QApplication::setActiveWindow(open->window.get());
    open->waitUntilIdle();
    const auto progress = progressIn(session);
    const auto chosen = std::ranges::find_if(progress->sightings, [](const FollowedSighting& one) {
      return one.position == 0u && one.planned.point == 12 && one.planned.round == 1;
    });
    (*open)->reveal({.position = 0, .reading = 4, .field = "horizontal"});
    (*open)->document().setChosenSighting(chosen - progress->sightings.begin());
    QTest::keyClick(QApplication::focusWidget(), '3');
    ASSERT_TRUE(waitFor([&] { return QDir(kept).entryList({QStringLiteral("*.typed")}).size() == 1; }));
  }
  const auto open = openWindow();
  open->dialogs->recoveries = {{Choice::Recover, 0}};
  ASSERT_TRUE((*open)->offerRecovery());
  const auto& rows = (*open)->document().session().positions[0].readings;
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[4].horizontal, "3");
  EXPECT_EQ(rows[4].point, "12");
}

/// A committed entry is part of the record itself; a cancelled one is in no record.
TEST_F(SafekeepingTest, HalfTypedIsKeptOnlyAsLongAsItIs) {
  const auto open = openWindow(file);
  QApplication::setActiveWindow(open->window.get());
  open->waitUntilIdle();
  const auto typedRecords = [&] { return QDir(kept).entryList({QStringLiteral("*.typed")}).size(); };
  (*open)->reveal({.field = "operator"});
  QTest::keyClick(QApplication::focusWidget(), 'A');
  ASSERT_TRUE(waitFor([&] { return typedRecords() == 1; }));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return typedRecords() == 0 && records().isEmpty(); }));
  QTest::keyClick(QApplication::focusWidget(), 'B');
  ASSERT_TRUE(waitFor([&] { return typedRecords() == 1; }));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(waitFor([&] { return typedRecords() == 0 && records().size() == 1; }));
}

TEST_F(SafekeepingTest, LeavesARecordThatCannotBeReadWhereItIs) {
  QDir().mkpath(kept);
  QFile broken(kept + QStringLiteral("/x.unsaved"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("{\"half\": ");
  broken.close();
  const auto open = openWindow();
  EXPECT_FALSE((*open)->offerRecovery());
  EXPECT_THAT((*open)->statusBar()->currentMessage().toStdString(), HasSubstr("x.unsaved cannot be read"));
  EXPECT_EQ(records().size(), 1);
}

}  // namespace
}  // namespace alidade::ui
