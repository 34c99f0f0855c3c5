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

/// Keeps unsaved changes of the current session in a folder, and offers unsaved changes of crashed windows.
/// Also keeps unfinished entries of forms outside the session, for the lifetime of this object.
class Safekeeping : public QObject {
  Q_OBJECT

 public:
  Safekeeping(SessionDocument& document, FileFlow& files, Dialogs& dialogs, const QString& folder,
              QObject* parent = nullptr);
  ~Safekeeping() override;

  /// Asks about unsaved changes that crashed windows left, until all are discarded, one is recovered or the
  /// user postpones; returns the number of questions. Records equal to their file are deleted without asking.
  int offer();
  /// Keeps everything unsaved or unfinished before it returns, as the process is about to end.
  void keepNow();
  /// Removes the record, because the window closes normally.
  void finish() { m_keeper.finish(); }
  /// A label owned by the status bar. While unsaved changes cannot be kept, it is visible and says why.
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
  QString m_recordTrouble, m_draftsTrouble;  ///< why record or drafts cannot be kept; else empty
  QLabel* m_trouble;
};

}  // namespace alidade::ui
