#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "ui/dialogs/recovery_dialog.h"
#include "ui/recovery/recovery_keeper.h"
#include "ui/recovery/recovery_record.h"

namespace alidade::ui {

class Dialogs;
class FileFlow;
class SessionDocument;

/// Keeps unsaved changes of the session at work in a folder, and offers those that crashed windows left
/// there.
class Safekeeping : public QObject {
  Q_OBJECT

 public:
  Safekeeping(SessionDocument& document, FileFlow& files, Dialogs& dialogs, const QString& folder,
              QObject* parent = nullptr);

  /// Asks about everything left behind. What differs from its file in nothing is cleared away unasked, and
  /// what is put off stays. Answers with how many were asked about.
  int offer();
  /// The window is left properly.
  void finish() { m_keeper.finish(); }
  QString recordPath() const { return m_keeper.path(); }

 signals:
  void remark(const QString& text);

 private:
  struct Left {
    std::unique_ptr<RecoverySlot> slot;
    RecoveryRecord record;
    RecoveryOffer offer;
  };

  std::vector<Left> leftBehind();
  bool recover(Left& left);

  SessionDocument& m_document;
  FileFlow& m_files;
  Dialogs& m_dialogs;
  QString m_folder;
  RecoveryKeeper m_keeper;
};

}  // namespace alidade::ui
