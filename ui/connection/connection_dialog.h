#pragma once

#include <QDialog>

class QLabel;
class QPushButton;

namespace alidade::ui {

class ConnectionForm;
class Dialogs;
class InstrumentLink;
class WireLog;

/// The dialog that connects an instrument and shows the communication. May stay open next to the window;
/// closing the dialog keeps the connection.
class ConnectionDialog : public QDialog {
  Q_OBJECT

 public:
  ConnectionDialog(InstrumentLink& link, Dialogs& dialogs, QWidget* parent = nullptr);

  ConnectionForm& form() { return *m_form; }
  WireLog& log() { return *m_log; }
  bool saveLog();
  /// Shows a sentence about the connection, and adds it to the log.
  void showRemark(const QString& sentence);
  /// Clears the shown sentence; the log keeps it.
  void clearRemark();

 signals:
  void connectWanted();
  void takeWanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* createButtons();
  void showState();

  InstrumentLink& m_link;
  Dialogs& m_dialogs;
  ConnectionForm* m_form;
  WireLog* m_log;
  QLabel *m_status, *m_said;
  QPushButton *m_connect, *m_take, *m_save;
};

/// "TS16, serial 123456: connected", for the dialog and the status bar.
QString connectionText(const InstrumentLink& link);

}  // namespace alidade::ui
