#pragma once

#include <QObject>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Copies an instrument record (`InstrumentRecord`) into the current session, or saves the session's
/// instrument as a record. Each function returns true on success, false if it failed (the user was told why)
/// or was cancelled.
class InstrumentFlow : public QObject {
  Q_OBJECT

 public:
  InstrumentFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool take();
  bool save();

 signals:
  void commitWanted();  ///< unfinished entries must be committed before the session is used
  void remark(const QString& text);

 private:
  SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
