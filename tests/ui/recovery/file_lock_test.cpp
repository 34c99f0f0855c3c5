#include "ui/recovery/file_lock.h"

#include <gmock/gmock.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace alidade::ui {
namespace {

class FileLockTest : public ::testing::Test {
 protected:
  FileLockTest() {
    for (FileLock* lock : {&mine, &theirs}) lock->setFolder(folder.filePath(QStringLiteral("locks")));
    for (const QString& path : {file, other}) QFile(path).open(QIODevice::WriteOnly);
    QFile::link(file, link);
  }

  QTemporaryDir folder;
  QString file = folder.filePath(QStringLiteral("a")), other = folder.filePath(QStringLiteral("b")),
          link = folder.filePath(QStringLiteral("link"));
  FileLock mine, theirs;
};

TEST_F(FileLockTest, TellsWhoHasTheFileOpen) {
  mine.hold(file);
  const QString process = QStringLiteral("process %1").arg(QCoreApplication::applicationPid());
  EXPECT_EQ(theirs.holder(file), process);
  EXPECT_EQ(theirs.holder(link), process) << "one file by two names";
  EXPECT_EQ(theirs.holder(other), QString());
  EXPECT_EQ(mine.holder(file), QString()) << "it is this window";
  theirs.hold(file);
  EXPECT_EQ(mine.holder(file), QString());
  mine.hold(other);
  EXPECT_EQ(theirs.holder(file), QString());
  theirs.hold(file);
  EXPECT_EQ(mine.holder(file), process) << "free by then, it was taken";
  theirs.hold({});
  EXPECT_EQ(mine.holder(file), QString());
}

TEST_F(FileLockTest, HoldsNothingWithoutAFolder) {
  FileLock none;
  none.hold(file);
  EXPECT_EQ(mine.holder(file), QString());
  mine.hold(file);
  EXPECT_EQ(none.holder(file), QString());
}

// The lock of a killed process names a process that no longer exists, here one with the largest number.
TEST_F(FileLockTest, TakesNoNoticeOfALockWhoseProcessIsGone) {
  mine.hold(file);
  const QDir locks(folder.filePath(QStringLiteral("locks")));
  const QStringList names = locks.entryList(QDir::Files);
  ASSERT_EQ(names.size(), 1);
  const QString path = locks.filePath(names[0]), copy = path + QStringLiteral(".copy");
  ASSERT_TRUE(QFile::copy(path, copy));
  mine.hold({});
  QFile stale(copy);
  ASSERT_TRUE(stale.open(QIODevice::ReadOnly));
  QByteArray content = stale.readAll();
  content.replace(QByteArray::number(QCoreApplication::applicationPid()), QByteArray("4194304"));
  QFile lock(path);
  ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
  lock.write(content);
  lock.close();
  EXPECT_EQ(theirs.holder(file), QString());
}

}  // namespace
}  // namespace alidade::ui
