#include "ui/recovery/file_lock.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <utility>

#include "ui/document/private_folder.h"

namespace alidade::ui {

namespace {

/// One name per file, with links resolved.
QString nameOf(const QString& path) {
  const QString canonical = QFileInfo(path).canonicalFilePath();
  return canonical.isEmpty() ? QFileInfo(path).absoluteFilePath() : canonical;
}

}  // namespace

std::unique_ptr<QLockFile> FileLock::lockOf(const QString& path) const {
  const QByteArray hash = QCryptographicHash::hash(nameOf(path).toUtf8(), QCryptographicHash::Sha256);
  makePrivateFolder(m_folder);
  auto lock = std::make_unique<QLockFile>(
      QDir(m_folder).filePath(QString::fromLatin1(hash.toHex().left(32)) + QStringLiteral(".open")));
  lock->setStaleLockTime(0);
  return lock;
}

QString FileLock::holder(const QString& path) const {
  if (m_folder.isEmpty() || (m_lock && nameOf(path) == m_path)) return {};
  const auto lock = lockOf(path);
  if (lock->tryLock(0) || lock->error() != QLockFile::LockFailedError) return {};
  qint64 process = 0;
  QString host, program;
  if (!lock->getLockInfo(&process, &host, &program)) return {};
  return QCoreApplication::translate("FileLock", "process %1").arg(process);
}

void FileLock::hold(const QString& path) {
  const QString name = path.isEmpty() ? QString() : nameOf(path);
  if (m_folder.isEmpty() || (m_lock && name == m_path)) return;
  m_lock.reset();
  m_path = name;
  if (path.isEmpty()) return;
  m_lock = lockOf(path);
  if (!m_lock->tryLock(0)) m_lock.reset();
}

}  // namespace alidade::ui
