#pragma once

#include <QObject>
#include <optional>

#include "core/base/problem.h"
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

/// Owns the connection to the instrument and its dialog, and transfers the readings of the instrument into
/// the session.
class InstrumentDesk : public QObject {
  Q_OBJECT

 public:
  InstrumentDesk(SessionDocument& document, Dialogs& dialogs, const FitJob& job, QWidget& window);

  InstrumentLink& link() { return m_link; }
  ReadingFlow& flow() { return m_flow; }
  ConnectionDialog& dialog();
  ReadingQuestionBar* questionBar() const { return m_bar; }  ///< for the layout next to the readings
  QLabel* status() const { return m_status; }                ///< for the status bar
  /// The tables that receive the readings.
  void setPositions(PositionTabs& positions);

  /// While `isHeld`, nothing from the instrument changes the session.
  void setHeld(bool isHeld);

  void showDialog();
  /// Connects with the chosen settings, or disconnects.
  void toggle();
  /// Requests a reading; shows the dialog if there is no connection.
  void take();

 signals:
  void landed(const alidade::Place& place);
  void remark(const QString& sentence);

 private:
  TalkCircles circles() const;
  ReadingFlow::Front front() const;
  void accept(const InstrumentReading& reading);
  void report(const QString& sentence);
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
  std::optional<int> m_takingFor;  ///< number of the session for which a reading was requested
  bool m_isHeld = false;
  bool m_isIdentityDue = false;          ///< the instrument named itself while the session was held
  bool m_hasRemark = false;              ///< a failure is shown and nothing has succeeded since
  ConnectionDialog* m_dialog = nullptr;  ///< null until first shown
  ReadingQuestionBar* m_bar;
  QLabel* m_status;
};

}  // namespace alidade::ui
