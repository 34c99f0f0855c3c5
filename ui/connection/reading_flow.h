#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <functional>

#include "core/connection/instrument_reading.h"
#include "ui/connection/reading_doubts.h"
#include "ui/connection/reading_landing.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

class SessionDocument;

/// Stores readings of an instrument in the session, one after the other. Each reading waits until the
/// previous one is evaluated, so that the expected reading is known. A doubtful reading (`readingQuestion`)
/// waits for an answer, and later readings wait behind it. Never blocks the window, never loses a reading of
/// the session that it was taken for, and never gives it to another session.
class ReadingFlow : public QObject {
  Q_OBJECT

 public:
  explicit ReadingFlow(SessionDocument& document, QObject* parent = nullptr);

  /// Where the next reading goes: the position in front and, with `intoSelected`, its selected row.
  struct Front {
    std::size_t position = 0;
    std::optional<std::size_t> selected = {};
  };
  void setFront(std::function<Front()> front) { m_front = std::move(front); }

  /// A reading without a time gets the present time.
  void add(const InstrumentReading& reading);
  /// The evaluation of the current session; the next change of the session drops it.
  void setEvaluation(const SharedEvaluation& evaluation);

  /// While `isHeld`, readings wait.
  void setHeld(bool isHeld);

  /// `takeAnyway` stores the reading in question, `discard` drops it.
  void takeAnyway();
  void discard();

  QString question() const { return m_question; }  ///< empty: no question
  std::size_t waiting() const { return m_waiting.size(); }
  /// True if readings wait because an entry of a position is open: a reading never changes an open entry.
  bool isHeldByEntry() const;

 signals:
  void questionChanged();
  void heldChanged();
  void landed(const alidade::Place& place);
  void remark(const QString& sentence);

 private:
  void proceed();
  void leaveSession();
  std::optional<Landing> landing() const;
  void landFirst(const Landing& landing);
  void ask(const QString& question);

  SessionDocument& m_document;
  std::function<Front()> m_front;
  SharedEvaluation m_evaluation;  ///< null if the session changed after the last evaluation
  std::deque<InstrumentReading> m_waiting;
  int m_session;  ///< number of the session that the waiting readings were taken for
  TakenBefore m_before;
  QString m_question;  ///< about the first waiting reading
  bool m_isHeld = false;
};

}  // namespace alidade::ui
