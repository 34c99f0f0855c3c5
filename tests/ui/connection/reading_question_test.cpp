#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/connection/geocom_message.h"
#include "tests/ui/connection/landing_window.h"
#include "ui/commands/change_session.h"
#include "ui/commands/session_commands.h"
#include "ui/connection/reading_question_bar.h"
#include "ui/document/session_document.h"

// Questions about a reading before it is stored, without a protocol.

namespace alidade::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Points 1 to 4 in face 1 at 0°, as in the paper; none at 180°.
Session begunWithoutProtocol() {
  Session session = paperSession();
  session.positions[0].readings.resize(4);
  session.positions[1].zero = {};
  session.positions[1].readings.clear();
  return session;
}

TEST(ReadingQuestion, AZeroInFaceTwoIsNoPointWithoutAProtocolEither) {
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  InstrumentReading zero = readingOf("152°32'51\"", "270°00'05\"");
  EXPECT_THAT(window.add(zero), AllOf(HasSubstr("points at the pointing zero"), HasSubstr("face 2")));
  EXPECT_EQ(window.session().positions[0].readings.size(), 4U) << "nothing is stored before it is answered";
  window.take();
  EXPECT_EQ(window.session().positions[0].zero.afterInTwo.horizontal, "152°32'51\"");
  EXPECT_THAT(window.session().positions[0].zero.afterInTwo.takenAt, Not(IsEmpty()));
  EXPECT_EQ(window.session().positions[0].readings.size(), 4U);
}

// While a session is saved or an import is chosen, a reading from the instrument waits. It then makes the
// session modified, so it cannot be taken for saved, nor be lost to the import.
TEST(ReadingQuestion, ReadingsWaitWhileTheSessionIsSavedOrReplaced) {
  const Session paper = paperSession();
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  const QTemporaryDir folder;
  window.open.dialogs->savePath = folder.filePath(QStringLiteral("held.alidade"));
  ASSERT_TRUE(window.open->files().save());
  emit window.open->files().holding(true);
  window.flow().add(readingOf(paper.positions[0].readings[4]));
  window.open.waitUntilIdle();
  EXPECT_EQ(window.flow().waiting(), 1U);
  EXPECT_FALSE(window.open->document().isModified());
  emit window.open->files().holding(false);
  EXPECT_TRUE(waitFor([&] { return window.session().positions[0].readings.size() == 5; }));
  EXPECT_TRUE(window.open->document().isModified());
}

TEST(ReadingQuestion, AnImportIsAddedToWhatCameMeanwhile) {
  const Session paper = paperSession();
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  window.open.waitUntilIdle();
  const QTemporaryDir folder;
  QFile file(folder.filePath(QStringLiteral("more.csv")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      "axis,point,horizontal,vertical\n180,ZERO,332°32'54\",89 59 57\n180,1,330°26'01\",91 03 46\n"
      "180,2,331°26'01\",91 33 46\n");
  file.close();
  window.open.dialogs->onImport = [&](ImportPage&) {
    window.flow().add(readingOf(paper.positions[0].readings[4]));
  };
  ASSERT_TRUE(window.open->files().importReadings({file.fileName()}));
  EXPECT_EQ(window.session().positions[1].readings.size(), 2U);
  EXPECT_TRUE(waitFor([&] { return window.session().positions[0].readings.size() == 5; }))
      << window.question();
}

/// A window with a session in a file, and two readings that wait for an answer.
struct TwoWaiting {
  QTemporaryDir folder;
  LandingWindow window{begunWithoutProtocol()};
  QPushButton* discard = window.open->findChild<QPushButton*>(QStringLiteral("discard questioned reading"));

  TwoWaiting() {
    window.putInFront(0);
    window.open.dialogs->savePath = folder.filePath(QStringLiteral("a.alidade"));
    EXPECT_TRUE(window.open->files().save());
    const InstrumentReading again = readingOf(paperSession().positions[0].readings[2]);
    EXPECT_THAT(window.add(again), Not(IsEmpty()));
    window.flow().add(readingOf(paperSession().positions[0].readings[4]));
  }
  FileFlow& files() { return window.open->files(); }
  ScriptedDialogs& dialogs() { return *window.open.dialogs; }
};

TEST(WaitingReadings, AreAskedAboutBeforeTheirSessionIsLeft) {
  TwoWaiting two;
  const Session before = two.window.session();
  EXPECT_FALSE(two.files().startNew());
  EXPECT_FALSE(two.window.open->close());
  EXPECT_EQ(two.dialogs().saveQuestions, 2);
  EXPECT_EQ(two.dialogs().leaving.waiting, 2U);
  EXPECT_FALSE(two.dialogs().leaving.isModified) << "there is nothing that saving would keep";
  EXPECT_EQ(two.window.session(), before);
  EXPECT_EQ(two.window.flow().waiting(), 2U) << "cancelled";
  ASSERT_TRUE(two.discard && two.discard->isVisible());
  two.discard->click();
  EXPECT_TRUE(waitFor([&] { return two.window.flow().waiting() == 0; })) << two.window.question();
  EXPECT_EQ(two.window.session().positions[0].readings.size(), 5U) << "the other is taken in";
}

TEST(WaitingReadings, AreAskedAboutAgainAfterSaving) {
  TwoWaiting two;
  changeField(two.window.open->document(), {.field = "title"}, "unsaved");
  EXPECT_TRUE(waitFor([&] { return !two.window.question().empty(); }));
  two.dialogs().saveAnswers = {Dialogs::SaveAnswer::Save};
  EXPECT_FALSE(two.files().startNew());
  EXPECT_FALSE(two.window.open->document().isModified()) << "saved";
  EXPECT_EQ(two.dialogs().saveQuestions, 2);
  EXPECT_EQ(two.window.flow().waiting(), 2U) << "saving takes nothing in";
}

TEST(WaitingReadings, AreGivenToNoOtherSession) {
  TwoWaiting two;
  two.dialogs().saveAnswer = Dialogs::SaveAnswer::Discard;
  ASSERT_TRUE(two.files().startNew());
  two.window.open.waitUntilIdle();
  EXPECT_EQ(two.window.flow().waiting(), 0U);
  EXPECT_FALSE(two.discard->isVisible());
  EXPECT_FALSE(two.window.open->document().isModified());
  EXPECT_EQ(two.window.session().positions[0].zero, PointingZero());
}

TEST(WaitingReadings, AreNotTakenIntoASessionThatUndoLeadsTo) {
  const Session first = begunWithoutProtocol();
  LandingWindow window(first);
  SessionDocument& document = window.open->document();
  document.pushAnother(new ReplaceSession(document, first, QStringLiteral("Import")));
  window.open.waitUntilIdle();
  window.putInFront(0);
  EXPECT_THAT(window.add(readingOf(paperSession().positions[0].readings[2])), Not(IsEmpty()));
  window.open->undo();
  window.open.waitUntilIdle();
  EXPECT_EQ(window.flow().waiting(), 0U);
  EXPECT_EQ(window.session(), first);
}

TEST(ReadingQuestion, AnotherPositionIsAsked) {
  Session session = paperSession();
  const Session paper = session;
  session.positions[1].zero = {};
  for (Reading& row : session.positions[1].readings) row.horizontal = row.vertical = "";
  LandingWindow window(session);
  EXPECT_THAT(window.add(firstZero(paper, 1)), HasSubstr("has the axis been turned?"));
  EXPECT_EQ(window.session().positions[1].zero.horizontal, "");
  window.take();
  EXPECT_EQ(window.session().positions[1].zero.horizontal, paper.positions[1].zero.horizontal);
  EXPECT_THAT(window.add(readingOf(paper.positions[1].readings[0])), IsEmpty()) << "asked once";
  EXPECT_EQ(window.session().positions[1].readings[0].horizontal, paper.positions[1].readings[0].horizontal);
}

TEST(ReadingQuestion, ABlockThatCameAlreadyIsAskedAlsoAsOneOfAPair) {
  const Session paper = paperSession();
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  const InstrumentReading a = readingOf(paper.positions[0].readings[4]),
                          b = readingOf(paper.positions[0].readings[5]);
  EXPECT_THAT(window.add(a), IsEmpty());
  EXPECT_THAT(window.add(b), IsEmpty());
  for (const InstrumentReading& again : {a, b, a}) {
    EXPECT_THAT(window.add(again), HasSubstr("did the instrument send them again?"));
    window.flow().discard();
  }
  EXPECT_THAT(window.add(readingOf(paper.positions[0].readings[2])), HasSubstr("Point 3"))
      << "what stands counts, whoever entered it";
  window.flow().discard();
  EXPECT_EQ(window.session().positions[0].readings.size(), 6U);
}

TEST(ReadingQuestion, AnotherSerialNumberIsAskedOnce) {
  Session session = begunWithoutProtocol();
  session.instrument.serial = "111";
  const Session paper = paperSession();
  LandingWindow window(session);
  window.putInFront(0);
  const auto from = [&](std::size_t row, const char* serial) {
    InstrumentReading reading = readingOf(paper.positions[0].readings[row]);
    reading.serial = serial;
    return reading;
  };
  EXPECT_THAT(window.add(from(4, "222")),
              AllOf(HasSubstr("111"), HasSubstr("222"), HasSubstr("The session's instrument has")));
  window.take();
  EXPECT_EQ(window.session().positions[0].readings[4].instrumentSerial, "222");
  EXPECT_THAT(window.add(from(5, "222")), IsEmpty()) << "it was taken";
  EXPECT_THAT(window.add(from(6, "111")), HasSubstr("The previous readings come from the instrument"));
}

TEST(ReadingQuestion, WhatTheInstrumentDoesNotVouchForIsAskedAndKeepsItsCode) {
  const Session paper = paperSession();
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  InstrumentReading reading = readingOf(paper.positions[0].readings[4]);
  reading.returnCode = "1284";
  reading.reservation = geoComSentence(1284);
  EXPECT_THAT(window.add(reading), AllOf(HasSubstr("uncertain accuracy"), HasSubstr("Return code 1284")));
  EXPECT_FALSE(window.open->instrumentDesk().questionBar()->isHidden());
  window.take();
  EXPECT_EQ(window.session().positions[0].readings[4].returnCode, "1284");
}

TEST(ReadingQuestion, ACompensatorThatIsOffAndOtherCorrectionsAreAskedOnce) {
  const Session paper = paperSession();
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  const auto with = [&](std::size_t row, bool isCompensated, const char* corrections) {
    InstrumentReading reading = readingOf(paper.positions[0].readings[row]);
    reading.isCompensated = isCompensated;
    reading.corrections = corrections;
    return reading;
  };
  EXPECT_THAT(window.add(with(4, true, "inclination")), IsEmpty());
  EXPECT_THAT(window.add(with(5, false, "none")),
              AllOf(HasSubstr("compensator is off"), HasSubstr("“none”")));
  window.take();
  EXPECT_THAT(window.add(with(6, false, "none")), IsEmpty());
}

TEST(ReadingQuestion, TheOtherFaceIsAskedOfANewRowAndLandsInItsFace) {
  Session session = begunWithoutProtocol();
  for (Reading& row : session.positions[0].readings) row.face = "1";
  LandingWindow window(session);
  window.putInFront(0);
  EXPECT_THAT(window.add(readingOf("160°00'00\"", "275°00'00\"")), HasSubstr("face 1 is asked for"));
  window.take();
  EXPECT_EQ(window.session().positions[0].readings[4].face, "2");
}

TEST(ReadingQuestion, AReadingThatNoPlaceIsAskedForIsAQuestion) {
  LandingWindow window(paperSession());
  EXPECT_THAT(window.add(readingOf("20°00'00\"", "80°00'00\"")), HasSubstr("all readings are already taken"));
  window.flow().takeAnyway();
  EXPECT_EQ(window.flow().waiting(), 1U) << "there is no place for it";
}

TEST(ReadingQuestion, WhatFailedIsOverOnceTheNextThingSucceeds) {
  LandingWindow window(begunWithoutProtocol());
  window.putInFront(0);
  InstrumentDesk& desk = window.open->instrumentDesk();
  QString shown;
  QObject::connect(&desk, &InstrumentDesk::remark, &desk, [&](const QString& sentence) { shown = sentence; });
  desk.take();
  EXPECT_THAT(shown.toStdString(), HasSubstr("No instrument is connected"));
  emit desk.link().succeeded();
  EXPECT_TRUE(shown.isEmpty());
}

}  // namespace
}  // namespace alidade::ui
