#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "ui/jobs/background.h"

namespace alidade::ui {

class SessionDocument;

/// The session's file, compared with the bytes last read or written here.
enum class FileState { Known, Changed, Missing };

/// Detects when another program writes or removes the current session's file. The result serves only for a
/// notice, since saving reads the file again.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(SessionDocument& document, QObject* parent = nullptr);

  /// Starts a check of the file; `stateChanged` reports a new result later. Also called when the window
  /// becomes active, since some file systems report no changes.
  void look();
  /// Suspends checks while the window itself writes the file.
  void setHeld(bool is);

 signals:
  void stateChanged(alidade::ui::FileState state);

 private:
  void follow();
  void finishReading(const QByteArray& sha256);
  FileState stateBy(const QByteArray& sha256) const;
  bool isToBeSeenAgain(FileState state);

  struct Seen {
    QString path;
    qint64 size = 0;
    QDateTime writtenAt;
    QByteArray knownSha256;

    bool operator==(const Seen&) const = default;
  };

  SessionDocument& m_document;
  QFileSystemWatcher m_watcher;
  QTimer m_timer;
  Seen m_seen;
  FileState m_state = FileState::Known;
  QElapsedTimer m_missing;  ///< started when the file was first found missing
  bool m_isHeld = false;
  bool m_isDue = false;  ///< a check was requested while another was running
  Background<QByteArray> m_reading;
};

}  // namespace alidade::ui
