#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "ui/jobs/background.h"

namespace alidade::ui {

class SessionDocument;

/// Detects when another program writes the current session's file. The result serves only for a notice, since
/// saving reads the file again.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(SessionDocument& document, QObject* parent = nullptr);

  bool isChanged() const { return m_isChanged; }
  /// Starts a check of the file; `changedElsewhere` reports a new result later. Also called when the window
  /// becomes active, since some file systems report no changes.
  void look();
  /// Suspends checks while the window itself writes the file.
  void setHeld(bool is);

 signals:
  void changedElsewhere(bool is);

 private:
  void follow();
  void finishReading(const QByteArray& sha256);

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
  bool m_isChanged = false;
  bool m_isHeld = false;
  bool m_isDue = false;  ///< a check was requested while another was running
  Background<QByteArray> m_reading;
};

}  // namespace alidade::ui
