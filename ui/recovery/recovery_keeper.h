#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/base/problem.h"
#include "ui/jobs/background.h"
#include "ui/recovery/recovery_slot.h"

namespace alidade::ui {

class SessionDocument;

/// Keeps the session at work in a record as long as it has changes that its file lacks: written behind the
/// edits, on a thread of its own, a quarter of a second after the first that is not in it yet.
class RecoveryKeeper : public QObject {
  Q_OBJECT

 public:
  RecoveryKeeper(SessionDocument& document, const QString& folder, QObject* parent = nullptr);

  /// Goes on in a record left behind, whose session is now at work.
  void adopt(std::unique_ptr<RecoverySlot> slot);
  /// The window is left properly: nothing is to be recovered.
  void finish();
  QString path() const { return m_slot->path(); }  ///< of the record

 signals:
  /// The record cannot be written. Told once, until it can again.
  void failed(const QString& sentence);

 private:
  using Written = std::optional<Problem>;

  void schedule();
  void keep();
  void finishWriting(const Written& problem);

  SessionDocument& m_document;
  std::unique_ptr<RecoverySlot> m_slot;
  QTimer m_timer;
  bool m_isDue = false;      ///< something is newer than what is being written
  bool m_hasFailed = false;  ///< as was told
  std::unique_ptr<Background<Written>> m_writing;
};

}  // namespace alidade::ui
