#pragma once

#include <QObject>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Protocols from and to files, and in a form. Each is true where it was done, false where it failed (the
/// user was told why) or was cancelled.
class ProtocolFlow : public QObject {
  Q_OBJECT

 public:
  ProtocolFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool load();
  bool save();
  bool edit();

 signals:
  void commitWanted();  ///< what is half typed belongs into the session before it is used
  void remark(const QString& text);

 private:
  SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
