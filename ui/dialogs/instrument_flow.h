#pragma once

#include <QObject>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Instrument records (`InstrumentRecord`): takes one into the session at work, and makes one of what the
/// session says of its instrument. Each is true where it was done, false where it failed (the user was told
/// why) or was cancelled.
class InstrumentFlow : public QObject {
  Q_OBJECT

 public:
  InstrumentFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool take();
  bool save();

 signals:
  void commitWanted();  ///< what is half typed belongs into the session before it is used
  void remark(const QString& text);

 private:
  SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
