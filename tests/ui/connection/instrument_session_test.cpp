#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <QDir>
#include <QLabel>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <cstdlib>

#include "core/base/angle_text.h"
#include "core/base/atomic_file.h"
#include "core/session/entry.h"
#include "core/session/session_file.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/ui/support.h"
#include "ui/connection/connection_dialog.h"
#include "ui/connection/connection_form.h"
#include "ui/connection/instrument_desk.h"
#include "ui/connection/reading_question_bar.h"
#include "ui/connection/wire_log.h"
#include "ui/main_window.h"
#include "ui/panels/readings/position_tabs.h"

// A whole session over the port of a simulated instrument, a separate program.

namespace alidade::ui {
namespace {

using testing::HasSubstr;
using Protocol = ConnectionSettings::Protocol;

/// 18 places in both faces in both positions: 72 sightings, and two pointing zeros.
Session sessionToRead() {
  alidade::Protocol protocol = *protocolByName("two-face");
  protocol.points = 18;
  protocol.first = Angle::fromDegrees(5);
  protocol.rounds = 1;
  Truth truth = drawTruth(11);
  return *simulate(protocol, truth, 11);
}

/// The same session without readings.
Session blankOf(Session session) {
  for (Position& position : session.positions) {
    position.zero = {};
    for (Reading& row : position.readings)
      row.horizontal = row.vertical = row.slider = row.tiltCrossArcsec = row.tiltLengthArcsec =
          row.corrections = {};
  }
  return session;
}

std::size_t rowsOf(const Session& session) {
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  return rows;
}

/// True if the system offers pseudo terminals for the simulated instrument; some containers lack them.
bool hasPseudoTerminals() {
  const int line = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (line < 0) return false;
  const bool isUsable = grantpt(line) == 0 && unlockpt(line) == 0 && access(ptsname(line), R_OK | W_OK) == 0;
  close(line);
  return isUsable;
}

class InstrumentSession : public testing::Test {
 protected:
  void SetUp() override {
    if (!hasPseudoTerminals()) GTEST_SKIP() << "there is no pseudo-terminal here";
  }
};

/// The simulator program, and the path of its port.
struct Simulator {
  QTemporaryDir folder;
  QProcess process;
  QString path;

  Simulator(const Session& session, const QStringList& options) {
    const std::string file = folder.filePath(QStringLiteral("truth.alidade")).toStdString();
    EXPECT_FALSE(writeFile(file, writeSession(session), {}));
    process.start(
        QStringLiteral(ALIDADE_CLI),
        QStringList{QStringLiteral("instrument-simulator"), QString::fromStdString(file)} + options);
    EXPECT_TRUE(waitFor([&] { return process.canReadLine() || process.state() == QProcess::NotRunning; }));
    EXPECT_TRUE(process.canReadLine()) << process.readAllStandardError().toStdString();
    path = QString::fromUtf8(process.readLine()).trimmed();
  }
  ~Simulator() {
    process.terminate();
    process.waitForFinished();
  }
};

struct Bench {
  OpenWindow open;

  InstrumentDesk& desk() { return open->instrumentDesk(); }
  const Session& session() { return open->document().session(); }
  ConnectionDialog& dialog() { return desk().dialog(); }
  std::string log() { return dialog().log().bytes(); }

  void start(const Session& session) {
    open->document().startWith(session);
    open.waitUntilIdle();
  }
  void connectTo(const QString& path, Protocol protocol) {
    ConnectionSettings settings = usualConnection(protocol);
    settings.port = path;
    dialog().form().setSettings(settings);
    desk().toggle();
    ASSERT_TRUE(desk().link().isOpen()) << log();
  }
  /// The program asks about the first sighting at 180°, although it is correct.
  bool takeAtNextPosition() {
    const QString question = desk().flow().question();
    if (!question.contains(QStringLiteral("has the axis been turned?"))) return false;
    if (question.contains(QStringLiteral("is it the right target?"))) return false;
    desk().flow().takeAnyway();
    return true;
  }
  std::size_t landed() {
    std::size_t count = 0;
    for (const Position& position : session().positions) {
      count += position.zero.horizontal.empty() ? 0 : 1;
      for (const Reading& row : position.readings) count += row.horizontal.empty() ? 0 : 1;
    }
    return count;
  }
};

/// The corrections encoded in the digits of the simulator's GSI words.
const std::string allCorrections = "inclination standing_axis collimation tilting_axis";

/// Compares each cell with the sent value, to `within` arcseconds.
void expectSame(const Session& read, const Session& sent, double within, bool isGsi = false) {
  ASSERT_EQ(read.positions.size(), sent.positions.size());
  const auto expectAngle = [&](const std::string& is, const std::string& was, const std::string& where) {
    const auto a = parseAngle(is), b = parseAngle(was);
    ASSERT_TRUE(a) << where << ": " << is;
    EXPECT_NEAR(wrapped(*a - *b).arcseconds(), 0, within) << where;
  };
  for (std::size_t p = 0; p < sent.positions.size(); ++p) {
    const std::string position = "position " + std::to_string(p);
    expectAngle(read.positions[p].zero.horizontal, sent.positions[p].zero.horizontal, position + " zero");
    expectAngle(read.positions[p].zero.vertical, sent.positions[p].zero.vertical, position + " zero");
    ASSERT_EQ(read.positions[p].readings.size(), sent.positions[p].readings.size());
    for (std::size_t i = 0; i < sent.positions[p].readings.size(); ++i) {
      const Reading &is = read.positions[p].readings[i], &was = sent.positions[p].readings[i];
      const std::string where = position + " row " + std::to_string(i);
      expectAngle(is.horizontal, was.horizontal, where);
      expectAngle(is.vertical, was.vertical, where);
      EXPECT_EQ(is.face, was.face) << where;
      EXPECT_EQ(is.tiltCrossArcsec, was.tiltCrossArcsec) << where;
      EXPECT_EQ(is.tiltLengthArcsec, was.tiltLengthArcsec) << where;
      EXPECT_EQ(is.corrections, isGsi ? allCorrections : was.corrections) << where;
      EXPECT_EQ(is.point, was.point) << where;
    }
  }
}

const QStringList everyFault = {
    QStringLiteral("--fault"), QStringLiteral("garbage"),       QStringLiteral("--fault"),
    QStringLiteral("cut"),     QStringLiteral("--fault"),       QStringLiteral("twice"),
    QStringLiteral("--fault"), QStringLiteral("busy"),          QStringLiteral("--fault"),
    QStringLiteral("wrong"),   QStringLiteral("--fault-every"), QStringLiteral("6")};

TEST_F(InstrumentSession, SeventyTwoSightingsByGeoComWithFaults) {
  Session sent = sessionToRead();
  ASSERT_EQ(rowsOf(sent), 72U);
  for (Position& position : sent.positions) {
    for (std::size_t i = 0; i < position.readings.size(); ++i) {
      position.readings[i].tiltCrossArcsec = std::to_string(i % 5) + ".25";
      position.readings[i].tiltLengthArcsec = "-" + std::to_string(1 + i % 3) + ".50";
      position.readings[i].corrections = "inclination standing_axis tilting_axis";
    }
  }
  Simulator simulator(
      sent, everyFault + QStringList{QStringLiteral("--uncorrected"), QStringLiteral("collimation")});
  Bench bench;
  bench.start(blankOf(sent));
  bench.connectTo(simulator.path, Protocol::GeoCom);
  ASSERT_TRUE(waitFor([&] { return !bench.desk().link().identity().serial.empty(); })) << bench.log();
  int wrong = 0;
  for (int turn = 0; turn < 200 && bench.landed() < 74; ++turn) {
    const std::size_t before = bench.landed();
    bench.desk().take();
    ASSERT_TRUE(waitFor([&] { return !bench.desk().link().isTaking(); })) << bench.log();
    ASSERT_TRUE(waitFor([&] { return bench.landed() > before || !bench.desk().flow().question().isEmpty(); }))
        << bench.log();
    if (bench.desk().flow().question().isEmpty()) continue;
    EXPECT_FALSE(bench.desk().questionBar()->isHidden());
    EXPECT_EQ(bench.landed(), before) << "nothing is taken before it is answered";
    if (bench.takeAtNextPosition()) continue;
    ++wrong;
    bench.desk()
        .questionBar()
        ->findChild<QPushButton*>(QStringLiteral("discard questioned reading"))
        ->click();
    EXPECT_TRUE(bench.desk().questionBar()->isHidden());
  }
  expectSame(bench.session(), sent, 5.1e-4);  // half of the last written digit
  EXPECT_EQ(wrong, 2) << "of 12 faults in turn the 5th and 10th";
  for (const char* said :
       {"was skipped", "Only part of a line came", "late or twice", "busy measuring", "was rejected"})
    EXPECT_THAT(bench.log(), HasSubstr(said));
  // Each reading is one undo step, and all can be undone.
  while (bench.open->document().undoStack().canUndo()) bench.open->undo();
  EXPECT_EQ(bench.landed(), 0U);
}

TEST_F(InstrumentSession, SeventyTwoSightingsByGsiWithFaults) {
  const Session sent = sessionToRead();
  for (const char* width : {"8", "16"}) {
    Simulator simulator(sent,
                        everyFault + QStringList{QStringLiteral("--protocol"), QStringLiteral("gsi"),
                                                 QStringLiteral("--width"), QString::fromLatin1(width)});
    Bench bench;
    bench.start(blankOf(sent));
    bench.connectTo(simulator.path, Protocol::Gsi);
    int wrong = 0;
    for (int turn = 0; turn < 200 && bench.landed() < 74; ++turn) {
      const std::size_t before = bench.landed();
      const std::string logBefore = bench.log();
      simulator.process.write("\n");  // the key REC
      ASSERT_TRUE(waitFor([&] {
        return bench.landed() > before || !bench.desk().flow().question().isEmpty() ||
               bench.log().find("@W100", logBefore.size()) != std::string::npos;
      })) << bench.log();
      if (bench.desk().flow().question().isEmpty()) continue;
      if (bench.takeAtNextPosition()) continue;
      ++wrong;
      bench.desk().flow().discard();
    }
    expectSame(bench.session(), sent, 0.051, true);  // half of a tenth of a second
    EXPECT_EQ(wrong, 2);
    EXPECT_THAT(bench.log(), HasSubstr("used once"));
  }
}

TEST_F(InstrumentSession, AQuestionedReadingIsTakenWhenWanted) {
  const Session sent = sessionToRead();
  Simulator simulator(sent, {QStringLiteral("--protocol"), QStringLiteral("gsi")});
  Bench bench;
  Session blank = blankOf(sent);
  blank.positions[0].readings[0].face = "2";  // the instrument reads in face 1
  bench.start(blank);
  bench.connectTo(simulator.path, Protocol::Gsi);
  for (int i = 0; i < 3; ++i) {
    simulator.process.write("\n");
    ASSERT_TRUE(waitFor([&] {
      return bench.landed() + bench.desk().flow().waiting() == static_cast<std::size_t>(i) + 1;
    })) << bench.log();
  }
  ASSERT_TRUE(waitFor([&] { return !bench.desk().flow().question().isEmpty(); })) << bench.log();
  EXPECT_THAT(bench.desk().flow().question().toStdString(), HasSubstr("face 2 is asked for"));
  EXPECT_EQ(bench.desk().flow().waiting(), 2U) << "what comes meanwhile waits behind it";
  bench.desk().flow().takeAnyway();
  ASSERT_TRUE(waitFor([&] { return bench.landed() == 3; }));
  EXPECT_EQ(bench.session().positions[0].readings[0].face, "1");
}

TEST_F(InstrumentSession, AReadingIsNotGivenToASessionOpenedMeanwhile) {
  Simulator simulator(sessionToRead(), {});
  Bench bench;
  bench.start(blankOf(sessionToRead()));
  bench.connectTo(simulator.path, Protocol::GeoCom);
  ASSERT_TRUE(waitFor([&] { return !bench.desk().link().identity().serial.empty(); })) << bench.log();
  bench.desk().take();
  ASSERT_TRUE(bench.desk().link().isTaking());
  bench.start(blankOf(sessionToRead()));
  ASSERT_TRUE(waitFor([&] { return !bench.desk().link().isTaking(); })) << bench.log();
  EXPECT_EQ(bench.landed() + bench.desk().flow().waiting(), 0U);
  bench.desk().take();
  EXPECT_TRUE(waitFor([&] { return bench.landed() == 1; })) << bench.log();
}

TEST_F(InstrumentSession, APortThatIsNotThereAndOneThatBreaksAreSentences) {
  Bench bench;
  bench.start(blankOf(sessionToRead()));
  ConnectionSettings settings;
  settings.port = QStringLiteral("/dev/there-is-no-such-port");
  bench.dialog().form().setSettings(settings);
  bench.desk().toggle();
  EXPECT_FALSE(bench.desk().link().isOpen());
  EXPECT_THAT(bench.log(), HasSubstr("could not be opened"));
  bench.desk().take();
  EXPECT_THAT(bench.log(), HasSubstr("No instrument is connected"));
  auto simulator = std::make_unique<Simulator>(sessionToRead(), QStringList());
  bench.connectTo(simulator->path, Protocol::GeoCom);
  ASSERT_TRUE(waitFor([&] { return !bench.desk().link().identity().serial.empty(); }));
  bench.desk().take();
  ASSERT_TRUE(waitFor([&] { return bench.landed() == 1; }));
  simulator.reset();
  ASSERT_TRUE(waitFor([&] { return !bench.desk().link().isOpen(); })) << bench.log();
  EXPECT_THAT(bench.log(), HasSubstr("The connection to the instrument broke"));
  EXPECT_EQ(bench.landed(), 1U) << "what was read stays";
}

TEST(InstrumentDesk, SettingsAreRememberedByProtocol) {
  ConnectionSettings settings = usualConnection(Protocol::Gsi);
  settings.port = QStringLiteral("ttyUSB7");
  settings.baudRate = 2400;
  rememberConnection(settings);
  EXPECT_EQ(rememberedConnection(), settings);
  EXPECT_EQ(rememberedConnection(Protocol::GeoCom).baudRate, 19200);
  EXPECT_EQ(rememberedConnection(Protocol::GeoCom).port, settings.port) << "the cable is in the same port";
  QSettings().setValue(QStringLiteral("connection/gsi/baudRate"), QStringLiteral("fast"));
  EXPECT_EQ(rememberedConnection(Protocol::Gsi).baudRate, 9600) << "what means nothing is as usual";
  QSettings().remove(QStringLiteral("connection"));
}

TEST(InstrumentDesk, TheLogIsSavedWithControlCharactersAsText) {
  Bench bench;
  const QTemporaryDir folder;
  bench.dialog().log().addLine(true, QStringLiteral("%R1Q,0,1:"));
  bench.dialog().log().addLine(false, QString::fromStdString(shownLine("a\x1b[2J")));
  bench.open.dialogs->exportPath = folder.filePath(QStringLiteral("wire.log"));
  EXPECT_TRUE(bench.dialog().saveLog());
  QFile file(bench.open.dialogs->exportPath);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const std::string text = file.readAll().toStdString();
  EXPECT_THAT(text, HasSubstr("→ %R1Q,0,1:\n"));
  EXPECT_THAT(text, HasSubstr("← a<1B>[2J\n"));
}

}  // namespace
}  // namespace alidade::ui
