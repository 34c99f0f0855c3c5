#include "ui/recovery/recovery_slot.h"

#include <QDir>
#include <QFile>
#include <QUuid>

#include "ui/document/private_folder.h"

namespace alidade::ui {

namespace {

const QString lockSuffix = QStringLiteral(".lock");

QString suffixOf(RecoverySlot::Kind kind) {
  return kind == RecoverySlot::Kind::Session ? QStringLiteral(".unsaved") : QStringLiteral(".drafts");
}

/// Removes locks of windows that were killed without unsaved changes.
void clearStaleLocks(const QDir& folder, const QString& suffix) {
  for (const QString& name : folder.entryList({u'*' + suffix + lockSuffix}, QDir::Files)) {
    const QString path = folder.filePath(name);
    if (QFile::exists(path.chopped(lockSuffix.size()))) continue;
    QLockFile lock(path);
    lock.setStaleLockTime(0);
    lock.tryLock(0);  // `lock` removes the file at the end of the block
  }
}

}  // namespace

/// A lock is stale if its process has ended, whatever its age.
RecoverySlot::RecoverySlot(const QString& path) : m_path(path), m_lock(path + lockSuffix) {
  m_lock.setStaleLockTime(0);
}

std::unique_ptr<RecoverySlot> RecoverySlot::create(const QString& folder, Kind kind) {
  makePrivateFolder(folder);
  const QDir dir(folder);
  const QString suffix = suffixOf(kind);
  clearStaleLocks(dir, suffix);
  const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces) + suffix;
  auto slot = std::unique_ptr<RecoverySlot>(new RecoverySlot(dir.filePath(name)));
  slot->m_lock.tryLock(0);
  return slot;
}

std::vector<std::unique_ptr<RecoverySlot>> RecoverySlot::leftBehind(const QString& folder, Kind kind) {
  const QDir dir(folder);
  std::vector<std::unique_ptr<RecoverySlot>> found;
  for (const QString& name : dir.entryList({u'*' + suffixOf(kind)}, QDir::Files, QDir::Name)) {
    auto slot = std::unique_ptr<RecoverySlot>(new RecoverySlot(dir.filePath(name)));
    if (slot->m_lock.tryLock(0) && QFile::exists(slot->m_path)) found.push_back(std::move(slot));
  }
  return found;
}

QString RecoverySlot::typedPath() const {
  return m_path + QStringLiteral(".typed");
}

void RecoverySlot::remove() const {
  QFile::remove(typedPath());
  QFile::remove(m_path);
}

}  // namespace alidade::ui
