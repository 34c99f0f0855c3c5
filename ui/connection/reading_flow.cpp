#include "ui/connection/reading_flow.h"

#include <QDateTime>
#include <utility>

#include "core/session/face.h"
#include "ui/document/session_document.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

/// Returns the time to the second, with the time zone of this computer: "2026-03-14T15:09:26+01:00".
std::string timeOfNow() {
  const QDateTime now = QDateTime::currentDateTime();
  return now.toOffsetFromUtc(now.offsetFromUtc()).toString(Qt::ISODate).toStdString();
}

}  // namespace

ReadingFlow::ReadingFlow(SessionDocument& document, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_front([] { return Front(); }),
      m_session(document.sessionNumber()) {
  connect(&document, &SessionDocument::changed, this, [this](const SessionChange& change) {
    m_evaluation.reset();
    const bool isOfOthers =
        change.kind == SessionChange::Kind::Everything || change.kind == SessionChange::Kind::Positions;
    if (isOfOthers) m_before = {};
  });
  connect(&document, &SessionDocument::identityChanged, this, &ReadingFlow::leaveSession);
  // Queued, since `HalfTyped` drops a committed entry before the session receives that entry.
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
  if (reading.takenAt.empty()) m_waiting.back().takenAt = timeOfNow();
  if (!m_question.isEmpty()) emit questionChanged();  // the bar shows how many readings wait
  proceed();
  emit heldChanged();
}

/// Drops the readings that were taken for a session that is no longer current. `FileFlow` asked about them,
/// unless undo or redo led to another session.
void ReadingFlow::leaveSession() {
  if (std::exchange(m_session, m_document.sessionNumber()) == m_document.sessionNumber()) return;
  const std::size_t dropped = std::exchange(m_waiting, {}).size();
  ask({});
  if (dropped == 0) return;
  emit heldChanged();
  emit remark(
      tr("Readings that waited for the session before, and were not taken into this one: %1.").arg(dropped));
}

void ReadingFlow::setHeld(bool isHeld) {
  m_isHeld = isHeld;
  proceed();
}

bool ReadingFlow::isHeldByEntry() const {
  return !m_waiting.empty() && m_document.halfTyped().isOpenInPosition();
}

/// Drops the question and examines the first waiting reading again: the user may have typed its entry.
void ReadingFlow::setEvaluation(const SharedEvaluation& evaluation) {
  m_evaluation = evaluation;
  ask({});
  proceed();
}

std::optional<Landing> ReadingFlow::landing() const {
  const Front front = m_front();
  if (front.selected) return landingInRow(m_evaluation->session, front.position, *front.selected);
  return nextLanding(*m_evaluation, front.position, m_waiting.front());
}

void ReadingFlow::proceed() {
  if (m_waiting.empty() || !m_evaluation || !m_question.isEmpty() || m_isHeld || isHeldByEntry()) return;
  const auto where = landing();
  const QString question = where ? readingQuestion(*m_evaluation, *where, m_waiting.front(), m_before)
                                 : placelessQuestion(*m_evaluation, m_waiting.front());
  question.isEmpty() ? landFirst(*where) : ask(question);
}

void ReadingFlow::landFirst(const Landing& where) {
  const InstrumentReading reading = m_waiting.front();
  m_waiting.pop_front();
  m_before.add(reading, where.position());
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
  emit remark(tr("The reading was rejected: %1 and %2, %3.")
                  .arg(qText(reading.horizontal), qText(reading.vertical), qText(faceName(reading.face))));
  proceed();
}

}  // namespace alidade::ui
