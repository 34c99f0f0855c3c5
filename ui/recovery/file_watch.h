#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include "ui/jobs/background.h"

namespace alidade::ui {

class SessionDocument;

/// Notices when others write the file of the session at work. For a notice only: who saves reads the file
/// again.
class FileWatch : public QObject {
  Q_OBJECT

 public:
  explicit FileWatch(SessionDocument& document, QObject* parent = nullptr);

  bool isChanged() const { return m_isChanged; }
  /// Looks at the file, as when the window comes to the front: not every disk tells of its changes. What it
  /// finds is told a little later.
  void look();
  /// While the window itself writes the file, nothing is looked at.
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
  bool m_isDue = false;  ///< to look again, for it was still reading
  Background<QByteArray> m_reading;
};

}  // namespace alidade::ui
