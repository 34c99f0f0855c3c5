#pragma once

#include <QObject>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Loads, saves and edits protocols. Each function returns true on success, false if it failed (the user was
/// told why) or was cancelled.
class ProtocolFlow : public QObject {
  Q_OBJECT

 public:
  ProtocolFlow(SessionDocument& document, Dialogs& dialogs, QObject* parent = nullptr);

  bool load();
  bool save();
  bool edit();

 signals:
  void commitWanted();  ///< unfinished entries must be committed before the session is used
  void remark(const QString& text);

 private:
  SessionDocument& m_document;
  Dialogs& m_dialogs;
};

}  // namespace alidade::ui
