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

/// Stores readings of an instrument in the session, one after the other. Each is stored once the previous one
/// is evaluated, so that it can be compared with the expected reading. A doubtful reading (`readingQuestion`)
/// waits for an answer, and later ones wait behind it. Never blocks or loses a reading.
class ReadingFlow : public QObject {
  Q_OBJECT

 public:
  explicit ReadingFlow(SessionDocument& document, QObject* parent = nullptr);

  /// Where the next reading goes: the position in front, and the selected row if the user chose that setting.
  struct Front {
    std::size_t position = 0;
    std::optional<std::size_t> selected = {};
  };
  void setFront(std::function<Front()> front) { m_front = std::move(front); }

  /// A reading without a time gets the present time.
  void add(const InstrumentReading& reading);
  /// The evaluation of the current session; the next change of the session drops it.
  void setEvaluation(const SharedEvaluation& evaluation);

  /// These two answer the current question: they store the reading or discard it.
  void takeAnyway();
  void discard();

  QString question() const { return m_question; }  ///< empty: no question
  std::size_t waiting() const { return m_waiting.size(); }
  /// True if readings wait because an entry of a position is open: a reading never changes an open entry.
  bool isHeld() const;

 signals:
  void questionChanged();
  void heldChanged();
  void landed(const alidade::Place& place);
  void remark(const QString& sentence);

 private:
  void proceed();
  std::optional<Landing> landing() const;
  void landFirst(const Landing& landing);
  void ask(const QString& question);

  SessionDocument& m_document;
  std::function<Front()> m_front;
  SharedEvaluation m_evaluation;  ///< null: the session has changed since
  std::deque<InstrumentReading> m_waiting;
  TakenBefore m_before;
  QString m_question;  ///< about the first waiting reading
};

}  // namespace alidade::ui
