#include "ui/connection/reading_flow.h"

#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

ReadingFlow::ReadingFlow(SessionDocument& document, QObject* parent)
    : QObject(parent), m_document(document), m_front([] { return Front(); }) {
  connect(&document, &SessionDocument::changed, this, [this] { m_evaluation.reset(); });
  // Later: an entry that is handed in has not changed the session yet.
  connect(
      &document.halfTyped(), &HalfTyped::changed, this,
      [this] {
        if (m_waiting.empty()) return;
        proceed();
        emit heldChanged();
      },
      Qt::QueuedConnection);
}

void ReadingFlow::add(const InstrumentReading& reading) {
  m_waiting.push_back(reading);
  if (!m_question.isEmpty()) emit questionChanged();  // one more waits
  proceed();
  emit heldChanged();
}

bool ReadingFlow::isHeld() const {
  return !m_waiting.empty() && m_document.halfTyped().isOpenInPosition();
}

/// A question is asked anew: what it is about may have been typed meanwhile.
void ReadingFlow::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  ask({});
  proceed();
}

std::optional<Landing> ReadingFlow::landing() const {
  const Front front = m_front();
  if (front.selected) return Landing{front.position, front.selected};
  return nextLanding(*m_evaluation, front.position);
}

void ReadingFlow::proceed() {
  if (m_waiting.empty() || !m_evaluation || !m_question.isEmpty() || isHeld()) return;
  const auto where = landing();
  if (!where)
    return ask(
        tr("A reading came, and all is read that was to be: %1 and %2. Add a row, or choose one to be read "
           "again, then take it.")
            .arg(qText(m_waiting.front().horizontal), qText(m_waiting.front().vertical)));
  const QString doubt = landingDoubt(*m_evaluation, *where, m_waiting.front());
  doubt.isEmpty() ? landFirst(*where) : ask(doubt);
}

void ReadingFlow::landFirst(const Landing& where) {
  const InstrumentReading reading = m_waiting.front();
  m_waiting.pop_front();
  land(m_document, where, reading);
  emit landed(where.place());
}

void ReadingFlow::ask(const QString& question) {
  if (m_question == question) return;
  m_question = question;
  emit questionChanged();
}

void ReadingFlow::takeAnyway() {
  if (m_question.isEmpty() || !m_evaluation) return;
  const auto where = landing();
  if (!where) return;
  ask({});
  landFirst(*where);
}

void ReadingFlow::discard() {
  if (m_question.isEmpty()) return;
  const InstrumentReading reading = m_waiting.front();
  m_waiting.pop_front();
  ask({});
  emit remark(tr("A reading was not taken, as you wished: %1 and %2, face %3.")
                  .arg(qText(reading.horizontal), qText(reading.vertical))
                  .arg(reading.face));
  proceed();
}

}  // namespace alidade::ui
