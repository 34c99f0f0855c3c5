#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <random>

#include "core/base/file_bytes.h"
#include "core/session/session_file.h"
#include "tests/ui/recovery/typist.h"
#include "tests/ui/support.h"
#include "ui/recovery/recovery_record.h"
#include "ui/recovery/recovery_slot.h"

// Kills a typing process, and compares the recovered edits with the committed ones.

namespace alidade::ui {
namespace {

struct Killed {
  std::map<int, std::int64_t> edits;
  std::int64_t at = 0;
};

class Kill : public ::testing::Test {
 protected:
  QString in(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }

  /// Types for `ms` after the first edit.
  Killed typeAndKill(const QString& file, int ms) {
    QFile::remove(in("log"));
    QProcess typist;
    typist.start(QCoreApplication::applicationFilePath(),
                 {QString::fromLatin1(typistOption), in("kept"), file, in("log")});
    const std::int64_t patience = steadyNanoseconds() + 60'000'000'000;
    while (QFileInfo(in("log")).size() == 0 && steadyNanoseconds() < patience) QThread::msleep(5);
    QThread::msleep(static_cast<unsigned long>(ms));
    Killed killed;
    killed.at = steadyNanoseconds();
    typist.kill();
    EXPECT_TRUE(typist.waitForFinished());
    EXPECT_EQ(typist.exitStatus(), QProcess::CrashExit);
    killed.edits = committedEdits(in("log"));
    return killed;
  }

  /// The number of the newest edit found in the file or in the recovery records, which are cleared.
  int newestFound(const QString& file) {
    int newest = 0;
    if (!file.isEmpty()) {
      const Result<Session> saved = loadSession(file.toStdString());
      EXPECT_TRUE(saved) << "the file is torn";
      if (saved) newest = QString::fromStdString(saved->title).toInt();
    }
    for (const auto& slot : RecoverySlot::leftBehind(in("kept"))) {
      const Result<RecoveryRecord> record = readRecovery(*readFile(slot->path().toStdString()));
      EXPECT_TRUE(record) << "the record is torn";
      slot->remove();
      if (!record) continue;
      newest = std::max(newest, QString::fromStdString(record->session.title).toInt());
      EXPECT_EQ(record->path, file);
    }
    return newest;
  }

  /// Lost edits must be younger than a second at the kill.
  void killAt(const QString& file, int ms) {
    const Killed killed = typeAndKill(file, ms);
    ASSERT_FALSE(killed.edits.empty());
    const int found = newestFound(file);
    const auto lost = killed.edits.upper_bound(found);
    const double age = lost == killed.edits.end() ? 0 : double(killed.at - lost->second) / 1e9;
    EXPECT_LT(age, 1.0) << "killed after " << ms << " ms, " << killed.edits.size() << " edits, " << found
                        << " found";
    std::printf(
        "killed %4d ms after the first edit: of %4zu edits the newest %3d lost, the oldest of them "
        "%.3f s old\n",
        ms, killed.edits.size(), killed.edits.rbegin()->first - found, age);
  }

  /// A random moment in ms; a repeated test gets another one.
  static int anyMoment() {
    static std::mt19937 random(13);
    return std::uniform_int_distribution(0, 2200)(random);
  }

  QTemporaryDir folder;
};

TEST_F(Kill, LosesNothingOlderThanASecondOfAFile) {
  const QString file = in("s.alidade");
  QFile::copy(samplePath(QStringLiteral("two-faces.alidade")), file);
  QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner);
  for (int i = 0; i < 3; ++i) killAt(file, anyMoment());
}

TEST_F(Kill, LosesNothingOlderThanASecondOfAnUntitledSession) {
  for (int i = 0; i < 2; ++i) killAt({}, anyMoment());
}

}  // namespace
}  // namespace alidade::ui
