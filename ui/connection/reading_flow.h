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

/// Takes readings of an instrument into the session, one after the other: each where it belongs, once what
/// was read before it is evaluated, so that it is held against what is expected there. One that anything
/// speaks against (`readingQuestion`) waits for an answer, and all that come meanwhile wait behind it.
/// Nothing is lost, and nothing waited for.
class ReadingFlow : public QObject {
  Q_OBJECT

 public:
  explicit ReadingFlow(SessionDocument& document, QObject* parent = nullptr);

  /// Where the next reading goes: the position in front and, where it is to be the selected row, that row.
  struct Front {
    std::size_t position = 0;
    std::optional<std::size_t> selected = {};
  };
  void setFront(std::function<Front()> front) { m_front = std::move(front); }

  /// A reading that does not say when it was taken was taken now.
  void add(const InstrumentReading& reading);
  /// Of the session as it is now, or of an earlier state while `isOld`.
  void setEvaluation(const SharedEvaluation& evaluation);

  /// Answers to the question that is asked.
  void takeAnyway();
  void discard();

  QString question() const { return m_question; }  ///< empty: none is asked
  std::size_t waiting() const { return m_waiting.size(); }
  /// Do they wait for an entry of a position that is being typed? A reading never touches it.
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
  QString m_question;  ///< about the first that waits
};

}  // namespace alidade::ui
