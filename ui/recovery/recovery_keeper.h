#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "ui/document/half_typed.h"
#include "ui/jobs/background.h"
#include "ui/recovery/recovery_record.h"
#include "ui/recovery/recovery_slot.h"

namespace alidade::ui {

class SessionDocument;

/// Keeps the session at work in a record as long as it has changes that its file lacks, what is half typed
/// included: written behind the keys, on a thread of its own, a quarter of a second after the first that is
/// not in it yet.
class RecoveryKeeper : public QObject {
  Q_OBJECT

 public:
  RecoveryKeeper(SessionDocument& document, const QString& folder, QObject* parent = nullptr);

  /// Goes on in a record left behind, whose session is now at work.
  void adopt(std::unique_ptr<RecoverySlot> slot);
  /// Writes what is not in the record yet and waits for it: the process is about to end.
  void keepNow();
  /// The window is left properly: nothing is to be recovered.
  void finish();
  QString path() const { return m_slot->path(); }  ///< of the record

 signals:
  /// The record cannot be written, and why; empty: it can again.
  void troubled(const QString& sentence);

 private:
  using Written = std::optional<Problem>;

  /// What is written at once.
  struct Due {
    QString path, typedPath;
    std::shared_ptr<const RecoveryRecord> record;  ///< null: the one that is there holds
    QString id;                                    ///< of the record
    std::vector<HalfTypedText> typed;
  };

  void noteChange();
  void schedule();
  void keep();
  bool isNeeded() const;
  Due takeDue();
  static Written write(const Due& due);
  void finishWriting(const Written& problem);
  void startWriter();

  SessionDocument& m_document;
  std::unique_ptr<RecoverySlot> m_slot;
  QTimer m_timer;
  QString m_recordId;          ///< of the record that is there
  bool m_isSessionDue = true;  ///< the session is not as in the record
  bool m_isDue = false;        ///< something is newer than what is being written
  QString m_trouble;           ///< as told
  std::unique_ptr<Background<Written>> m_writing;
};

}  // namespace alidade::ui
