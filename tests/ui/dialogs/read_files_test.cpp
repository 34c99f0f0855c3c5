// The window never overwrites a file that it has read.

#include <gmock/gmock.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "core/session/sighting_protocol.h"
#include "core/simulation/protocol.h"
#include "tests/ui/support.h"
#include "ui/connection/connection_dialog.h"
#include "ui/connection/instrument_desk.h"
#include "ui/dialogs/export_flow.h"
#include "ui/dialogs/instrument_flow.h"
#include "ui/dialogs/protocol_flow.h"
#include "ui/instrument/check_input.h"
#include "ui/instrument/instrument_dialog.h"
#include "ui/main_window.h"
#include "ui/report/report_choice.h"
#include "ui/window/side_windows.h"

namespace alidade::ui {
namespace {

class ReadFiles : public ::testing::Test {
 protected:
  ReadFiles() {
    copy("paper-table-1.alidade", "session.alidade");
    copy("instrument-check.gsi", "check.gsi");
    copy("t-1.alidade-instrument", "t-1.alidade-instrument");
    put("rows.csv", "axis,point,horizontal,vertical\n0,90,341 52 24,88 16 49\n");
    put("bench.alidade-protocol", writeProtocol(*templateNamed("there-and-back")));
    EXPECT_TRUE(open->files().open(in("session.alidade")));
    EXPECT_TRUE(open->files().importReadings({in("rows.csv")}));
    open.dialogs->recordPath = in("t-1.alidade-instrument");
    EXPECT_TRUE(open->instrument().take());
    open.dialogs->protocolPath = in("bench.alidade-protocol");
    EXPECT_TRUE(open->findChild<ProtocolFlow*>()->load());
    QImage(30, 20, QImage::Format_ARGB32).save(in("logo.png"));
    ReportChoice choice = rememberedReportChoice();
    choice.logoPath = in("logo.png");
    rememberReportChoice(choice);
    open->sideWindows().showInstrumentCheck();
    open->findChild<InstrumentDialog*>()->input().addFiles({in("check.gsi")});
    open.waitUntilIdle();
  }

  ~ReadFiles() override { rememberReportChoice({}); }

  QString in(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  void copy(const char* sample, const char* name) const {
    ASSERT_TRUE(QFile::copy(samplePath(QString::fromLatin1(sample)), in(name)));
    QFile::setPermissions(in(name), QFile::ReadOwner | QFile::WriteOwner);
  }
  void put(const char* name, const std::string& text) const {
    QFile file(in(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(text));
  }
  QByteArray bytesOf(const char* name) const {
    QFile file(in(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  /// All ways in which the window writes, to `path`.
  std::vector<std::pair<const char*, std::function<bool()>>> ways(const QString& path) {
    open.dialogs->exportPath = open.dialogs->reportPath = open.dialogs->savePath = path;
    return {{"report", [this] { return open->files().exportReport(); }},
            {"result", [this] { return open->exports().exportResult(); }},
            {"readings", [this] { return open->exports().exportReadings(); }},
            {"record", [this] { return open->instrument().save(); }},
            {"log", [this] { return open->instrumentDesk().dialog().saveLog(); }},
            {"check",
             [this] {
               auto* check = open->findChild<InstrumentDialog*>();
               EXPECT_TRUE(waitFor([check] { return !check->job().isAtWork(); }));
               return check->exportCsv();
             }},
            {"save as", [this] { return open->files().saveAs(); }}};
  }

  QTemporaryDir folder;
  OpenWindow open;
};

TEST_F(ReadFiles, StayWhereTheyAre) {
  for (const char* name :
       {"rows.csv", "t-1.alidade-instrument", "bench.alidade-protocol", "logo.png", "check.gsi"}) {
    const QByteArray before = bytesOf(name);
    for (const auto& [way, write] : ways(in(name))) {
      open.dialogs->problems.clear();
      EXPECT_FALSE(write()) << way << " over " << name;
      EXPECT_EQ(bytesOf(name), before) << way << " over " << name;
      EXPECT_EQ(open.dialogs->problems.size(), 1) << way << " over " << name;
    }
  }
}

TEST_F(ReadFiles, OfAnotherSessionAreFree) {
  open->document().startWith(paperSession());
  open.waitUntilIdle();
  open.dialogs->exportPath = in("rows.csv");
  EXPECT_TRUE(open->exports().exportReadings());
}

TEST_F(ReadFiles, AreNotTheSessionsOwn) {
  const auto written = ways(in("session.alidade"));
  EXPECT_FALSE(written[1].second()) << "a result over the session";
  EXPECT_TRUE(written.back().second()) << "the session itself";
}

}  // namespace
}  // namespace alidade::ui
