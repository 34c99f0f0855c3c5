#include "ui/recovery/file_watch.h"

#include <QFileInfo>
#include <utility>

#include "ui/document/filed_session.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

FileWatch::FileWatch(SessionDocument& document, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_reading([this](const std::shared_ptr<const QByteArray>& sha256) { finishReading(*sha256); }) {
  constexpr int settlingMs = 150;  // lets a writer finish
  m_timer.setSingleShot(true);
  m_timer.setInterval(settlingMs);
  const auto lookSoon = [this] { m_timer.start(); };
  connect(&m_timer, &QTimer::timeout, this, &FileWatch::look);
  connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, lookSoon);
  connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, lookSoon);
  connect(&document, &SessionDocument::identityChanged, this, [this, lookSoon] {
    follow();
    lookSoon();
  });
}

/// Also watches the folder, since replacing a file ends the watch on it.
void FileWatch::follow() {
  const QFileInfo file(m_document.path());
  QStringList wanted;
  if (file.isFile()) wanted.append(file.absoluteFilePath());
  if (!m_document.path().isEmpty() && QFileInfo(file.absolutePath()).isDir())
    wanted.append(file.absolutePath());
  const QStringList watched = m_watcher.files() + m_watcher.directories();
  if (watched == wanted) return;
  if (!watched.isEmpty()) m_watcher.removePaths(watched);
  if (!wanted.isEmpty()) m_watcher.addPaths(wanted);
}

void FileWatch::look() {
  if (m_isHeld) return;
  follow();
  if (m_reading.isAtWork()) {
    m_isDue = true;
    return;
  }
  const QFileInfo file(m_document.path());
  Seen seen{m_document.path(), file.size(), file.lastModified(), m_document.knownSha256()};
  if (seen == m_seen) return;
  m_seen = std::move(seen);
  m_reading.start([path = m_seen.path](const std::stop_token&) { return sha256OfFile(path); },
                  [](const std::string&) { return QByteArray(); });
}

void FileWatch::setHeld(bool is) {
  m_isHeld = is;
  if (!is) look();
}

FileState FileWatch::stateBy(const QByteArray& sha256) const {
  if (!sha256.isEmpty()) return sha256 == m_seen.knownSha256 ? FileState::Known : FileState::Changed;
  return m_seen.path.isEmpty() || QFileInfo::exists(m_seen.path) ? FileState::Known : FileState::Missing;
}

/// A file is missing once it has been missing for a while: a program that saves may remove it for a moment.
bool FileWatch::isToBeSeenAgain(FileState state) {
  constexpr int leastMs = 800, againMs = 1000;
  if (state != FileState::Missing) {
    m_missing.invalidate();
    return false;
  }
  if (!m_missing.isValid()) m_missing.start();
  if (m_missing.elapsed() >= leastMs) return false;
  m_seen = {};
  QTimer::singleShot(againMs, this, &FileWatch::look);
  return true;
}

/// Ignores the result if another file is current now, or if the session was saved meanwhile.
void FileWatch::finishReading(const QByteArray& sha256) {
  if (m_isHeld) {
    m_seen = {};
    return;
  }
  if (m_seen.path == m_document.path() && m_seen.knownSha256 == m_document.knownSha256()) {
    const FileState state = stateBy(sha256);
    if (!isToBeSeenAgain(state) && state != std::exchange(m_state, state)) emit stateChanged(state);
  }
  if (std::exchange(m_isDue, false)) look();
}

}  // namespace alidade::ui
