#include "ui/recovery/recovery_slot.h"

#include <gmock/gmock.h>

#include <QFile>
#include <QTemporaryDir>

namespace alidade::ui {
namespace {

void put(const QString& path) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
}

TEST(RecoverySlot, IsLeftBehindOnlyWhenNobodyHoldsIt) {
  const QTemporaryDir folder;
  const QString inside = folder.filePath(QStringLiteral("made/when/missing"));
  auto slot = RecoverySlot::create(inside), other = RecoverySlot::create(inside);
  EXPECT_NE(slot->path(), other->path());
  put(slot->path());
  put(other->path());
  EXPECT_TRUE(RecoverySlot::leftBehind(inside).empty()) << "both windows live";
  const QString path = slot->path();
  slot.reset();
  {
    const auto left = RecoverySlot::leftBehind(inside);
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0]->path(), path);
    EXPECT_TRUE(RecoverySlot::leftBehind(inside).empty()) << "offered by one window at a time";
  }
  EXPECT_EQ(RecoverySlot::leftBehind(inside).size(), 1u) << "put off, it stays";
  RecoverySlot::leftBehind(inside)[0]->remove();
  EXPECT_TRUE(RecoverySlot::leftBehind(inside).empty());
  EXPECT_TRUE(QFile::exists(other->path()));
}

}  // namespace
}  // namespace alidade::ui
