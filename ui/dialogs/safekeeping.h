#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "ui/dialogs/recovery_dialog.h"
#include "ui/recovery/recovery_keeper.h"
#include "ui/recovery/recovery_record.h"

class QLabel;

namespace alidade::ui {

class Dialogs;
class FileFlow;
class SessionDocument;

/// Keeps unsaved changes of the session at work in a folder, and offers those that crashed windows left
/// there. What is typed into forms that no session holds is kept beside them, as long as this lives.
class Safekeeping : public QObject {
  Q_OBJECT

 public:
  Safekeeping(SessionDocument& document, FileFlow& files, Dialogs& dialogs, const QString& folder,
              QObject* parent = nullptr);
  ~Safekeeping() override;

  /// Asks about everything left behind. What differs from its file in nothing is cleared away unasked, and
  /// what is put off stays. Answers with how many were asked about.
  int offer();
  /// The process is about to end: what is unsaved or half typed is kept before this returns.
  void keepNow();
  /// The window is left properly.
  void finish() { m_keeper.finish(); }
  /// Shown as long as unsaved changes cannot be kept, and says why; for the status bar, which owns it.
  QLabel* trouble() const { return m_trouble; }
  QString recordPath() const { return m_keeper.path(); }

 signals:
  void remark(const QString& text);

 private:
  struct Left {
    std::unique_ptr<RecoverySlot> slot;
    RecoveryRecord record;
    std::vector<HalfTypedText> typed;
    RecoveryOffer offer;
  };

  std::vector<Left> leftBehind();
  bool recover(Left& left);
  void showTrouble();

  SessionDocument& m_document;
  FileFlow& m_files;
  Dialogs& m_dialogs;
  QString m_folder;
  RecoveryKeeper m_keeper;
  QString m_recordTrouble, m_draftsTrouble;  ///< why it cannot be kept; empty: it can
  QLabel* m_trouble;
};

}  // namespace alidade::ui
