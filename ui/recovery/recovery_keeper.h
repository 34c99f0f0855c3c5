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

/// Keeps a record of the current session while the session has unsaved changes or unfinished entries. A
/// separate thread writes the record a quarter of a second after the first change that the record lacks.
class RecoveryKeeper : public QObject {
  Q_OBJECT

 public:
  RecoveryKeeper(SessionDocument& document, const QString& folder, QObject* parent = nullptr);

  /// Continues a recovered record, whose session is now current.
  void adopt(std::unique_ptr<RecoverySlot> slot);
  /// Writes pending changes and waits for the end of writing; called before the process ends.
  void keepNow();
  /// Removes the record, because the window closes normally.
  void finish();
  QString path() const { return m_slot->path(); }  ///< path of the record

 signals:
  /// Reports why the record cannot be written; empty: it can be written again.
  void troubled(const QString& sentence);

 private:
  using Written = std::optional<Problem>;

  /// The data of one write.
  struct Due {
    QString path, typedPath;
    std::shared_ptr<const RecoveryRecord> record;  ///< null: the existing record is valid
    QString id;                                    ///< id of the record
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
  QString m_recordId;          ///< id of the existing record
  bool m_isSessionDue = true;  ///< the session differs from the record
  bool m_isDue = false;        ///< newer data wait for the end of the running write
  QString m_trouble;           ///< the sentence last reported
  std::unique_ptr<Background<Written>> m_writing;
};

}  // namespace alidade::ui
