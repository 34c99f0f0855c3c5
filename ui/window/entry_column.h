#pragma once

#include <QObject>

#include "core/base/problem.h"

class QSplitter;
class QTabWidget;

namespace alidade::ui {

class ChangeReasonBar;
class FindingsPanel;
class InstrumentDesk;
class PositionTabs;
class ReadingsFinder;
class SessionDocument;
class SessionJobs;
class SuspectBar;

/// The left column of the window: forms of the session, its readings, and the findings.
class EntryColumn : public QObject {
  Q_OBJECT

 public:
  EntryColumn(SessionDocument& document, SessionJobs& jobs, InstrumentDesk& desk, const QWidget& window);

  QWidget* widget() const { return m_widget; }
  PositionTabs& positions() const { return *m_positions; }
  ReadingsFinder& finder() const { return *m_finder; }
  SuspectBar* suspects() const { return m_suspects; }
  ChangeReasonBar* changeReason() const { return m_changeReason; }
  /// Commits unfinished entries.
  void commit();
  /// Shows the entry of a reading or field, and focuses it if `takeFocus`.
  void reveal(const Place& place, bool takeFocus);
  /// Moves the selected readings to the next position.
  void moveReadings();

 signals:
  void commitWanted();  ///< asks to commit unfinished entries before the session is edited
  void revealWanted(const alidade::Place& place, bool takeFocus);
  void gapWanted();  ///< asks to show the page of the gap

 private:
  void createForms();
  QWidget* createFindings(bool isLow);
  void connectSuspects(SessionJobs& jobs);
  void connectFindings(SessionJobs& jobs);
  void giveFindingsRoom();
  void markForms();
  void revealReading(const Place& place, bool takeFocus);

  SessionDocument& m_document;
  QWidget* m_widget;
  QSplitter* m_column;  ///< forms and readings above findings
  QTabWidget* m_forms;
  PositionTabs* m_positions;
  FindingsPanel* m_findings;
  SuspectBar* m_suspects;
  ChangeReasonBar* m_changeReason;
  ReadingsFinder* m_finder;
};

}  // namespace alidade::ui
