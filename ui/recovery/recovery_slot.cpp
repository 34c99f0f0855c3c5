#include "ui/recovery/recovery_slot.h"

#include <QDir>
#include <QFile>
#include <QUuid>

namespace alidade::ui {

namespace {

const QString suffix = QStringLiteral(".unsaved");

}  // namespace

/// A lock is stale when its process is gone, never because it is old.
RecoverySlot::RecoverySlot(const QString& path) : m_path(path), m_lock(path + QStringLiteral(".lock")) {
  m_lock.setStaleLockTime(0);
}

std::unique_ptr<RecoverySlot> RecoverySlot::create(const QString& folder) {
  const QDir dir(folder);
  dir.mkpath(QStringLiteral("."));
  const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces) + suffix;
  auto slot = std::unique_ptr<RecoverySlot>(new RecoverySlot(dir.filePath(name)));
  slot->m_lock.tryLock(0);
  return slot;
}

std::vector<std::unique_ptr<RecoverySlot>> RecoverySlot::leftBehind(const QString& folder) {
  const QDir dir(folder);
  std::vector<std::unique_ptr<RecoverySlot>> found;
  for (const QString& name : dir.entryList({u'*' + suffix}, QDir::Files, QDir::Name)) {
    auto slot = std::unique_ptr<RecoverySlot>(new RecoverySlot(dir.filePath(name)));
    if (slot->m_lock.tryLock(0) && QFile::exists(slot->m_path)) found.push_back(std::move(slot));
  }
  return found;
}

void RecoverySlot::remove() const {
  QFile::remove(m_path);
}

}  // namespace alidade::ui
