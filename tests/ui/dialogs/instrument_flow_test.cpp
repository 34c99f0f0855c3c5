#include "ui/dialogs/instrument_flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include "core/session/instrument_record.h"
#include "core/session/taken_record.h"
#include "tests/ui/support.h"
#include "ui/document/session_document.h"
#include "ui/main_window.h"
#include "ui/panels/model/known_sizes_panel.h"

namespace alidade::ui {
namespace {

InstrumentRecord recordOfT1() {
  return {.name = "T-1",
          .serial = "4711",
          .date = "2026-03-01",
          .sigmaHorizontalArcsec = "1",
          .known = {{"collimation", "", "3.2", "0.5", "arcsec", "check"}}};
}

struct RecordBench {
  RecordBench() {
    path = folder.filePath(QStringLiteral("t-1.alidade-instrument"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) throw std::runtime_error("file");
    file.write(QByteArray::fromStdString(writeInstrumentRecord(recordOfT1())));
    open.dialogs->recordPath = path;
  }

  const Session& session() { return open->document().session(); }

  QTemporaryDir folder;
  QString path;
  OpenWindow open;
};

TEST(InstrumentFlow, TakesARecordInOneStepThatCanBeUndone) {
  RecordBench bench;
  const Session before = bench.session();
  bench.open->findChild<QPushButton*>(QStringLiteral("take record"))->click();
  EXPECT_EQ(bench.session().instrument.serial, "4711");
  EXPECT_EQ(bench.session().instrument.sigmaHorizontalArcsec, "1");
  ASSERT_EQ(bench.session().instrument.known.size(), 1u);
  EXPECT_EQ(bench.session().instrument.known[0].from,
            "instrument record t-1.alidade-instrument of 2026-03-01: check");
  EXPECT_EQ(bench.session().instrument.record.date, "2026-03-01");
  bench.open->document().undoStack().undo();
  EXPECT_EQ(bench.session(), before);
  bench.open->document().undoStack().redo();
  EXPECT_EQ(bench.session().instrument.record.file, "t-1.alidade-instrument");
  const int steps = bench.open->document().undoStack().count();
  EXPECT_TRUE(bench.open->instrument().take());
  EXPECT_EQ(bench.open->document().undoStack().count(), steps) << "nothing changes";
}

TEST(InstrumentFlow, RefusesTheRecordOfAnotherInstrument) {
  RecordBench bench;
  Session other = bench.session();
  other.instrument.serial = "4712";
  bench.open->document().startWith(other);
  EXPECT_FALSE(bench.open->instrument().take());
  ASSERT_EQ(bench.open.dialogs->problems.size(), 1);
  EXPECT_TRUE(
      bench.open.dialogs->problems.front().contains(QStringLiteral("“4712” is not the serial number")));
  EXPECT_TRUE(bench.session().instrument.known.empty());
}

TEST(InstrumentFlow, RefusesWhatIsNoRecord) {
  RecordBench bench;
  bench.open.dialogs->recordPath = samplePath(QStringLiteral("clean-session.alidade"));
  EXPECT_FALSE(bench.open->instrument().take());
  ASSERT_EQ(bench.open.dialogs->problems.size(), 1);
  EXPECT_TRUE(bench.open.dialogs->problems.front().contains(QStringLiteral("choose an instrument record")));
  bench.open.dialogs->recordPath.clear();
  EXPECT_FALSE(bench.open->instrument().take()) << "cancelled";
}

TEST(InstrumentFlow, SavesARecordThatCanBeTakenAgain) {
  RecordBench bench;
  ASSERT_TRUE(bench.open->instrument().take());
  bench.open.dialogs->exportPath = bench.folder.filePath(QStringLiteral("again.alidade-instrument"));
  bench.open->findChild<QPushButton*>(QStringLiteral("save record"))->click();
  const Result<InstrumentRecord> again = loadInstrumentRecord(bench.open.dialogs->exportPath.toStdString());
  ASSERT_TRUE(again) << again.problem().text();
  EXPECT_EQ(again->serial, "4711");
  EXPECT_EQ(again->date, "2026-03-01");
  ASSERT_EQ(again->known.size(), 1u);
  EXPECT_EQ(again->known[0].from, "check") << "as the record had it";
}

TEST(InstrumentFlow, TellsWhatCannotBeARecord) {
  RecordBench bench;
  Session session = bench.session();
  session.instrument.known = {{"collimation", "", "3", "", "arcsec"}};
  bench.open->document().startWith(session);
  bench.open.dialogs->exportPath = bench.folder.filePath(QStringLiteral("bad.alidade-instrument"));
  EXPECT_FALSE(bench.open->instrument().save());
  ASSERT_EQ(bench.open.dialogs->problems.size(), 1);
  EXPECT_TRUE(bench.open.dialogs->problems.front().contains(QStringLiteral("known[0].sigma")));
}

}  // namespace
}  // namespace alidade::ui
