#pragma once

#include <QObject>

#include "core/base/place.h"
#include "ui/connection/instrument_link.h"
#include "ui/connection/reading_flow.h"

class QLabel;
class QWidget;

namespace alidade::ui {

class ConnectionDialog;
class Dialogs;
class FitJob;
class PositionTabs;
class ReadingQuestionBar;
class SessionDocument;

/// The instrument at the window: its line, its dialog, and the way of its readings into the session.
class InstrumentDesk : public QObject {
  Q_OBJECT

 public:
  InstrumentDesk(SessionDocument& document, Dialogs& dialogs, const FitJob& job, QWidget& window);

  InstrumentLink& link() { return m_link; }
  ReadingFlow& flow() { return m_flow; }
  ConnectionDialog& dialog();
  ReadingQuestionBar* questionBar() const { return m_bar; }  ///< to be put beside the readings
  QLabel* status() const { return m_status; }                ///< to be put into the status bar
  /// The tables that readings go to.
  void setPositions(PositionTabs& positions);

  void showDialog();
  /// Connects as chosen, or disconnects.
  void toggle();
  /// Asks for a reading; shows the dialog where nothing is connected.
  void take();

 signals:
  void landed(const alidade::Place& place);
  void remark(const QString& sentence);

 private:
  TalkCircles circles() const;
  ReadingFlow::Front front() const;
  void tell(const QString& sentence);
  void forgetRemark();
  void showState();
  void noteIdentity();
  void goOn(const Place& place);

  SessionDocument& m_document;
  Dialogs& m_dialogs;
  QWidget& m_window;
  InstrumentLink m_link;
  ReadingFlow m_flow;
  PositionTabs* m_positions = nullptr;
  bool m_hasRemark = false;              ///< one is shown that nothing has succeeded since
  ConnectionDialog* m_dialog = nullptr;  ///< null until it is wanted
  ReadingQuestionBar* m_bar;
  QLabel* m_status;
};

}  // namespace alidade::ui
