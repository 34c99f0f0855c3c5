#include "ui/jobs/gap_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

GapJob::GapJob(QObject* parent)
    : QObject(parent),
      m_work([this](const SharedGap& gap) { finish(gap); }),
      m_completion([this](const SharedGap& gap) {
        if (!m_completion.isStopped()) emit completed(gap);
        complete();
      }) {
  m_rest.setSingleShot(true);
  connect(&m_rest, &QTimer::timeout, this, &GapJob::start);
}

void GapJob::request(SharedEvaluation evaluation) {
  if (evaluation != m_wanted) m_work.stop();
  dropCompletion();
  m_wanted = std::move(evaluation);
  m_rest.start(m_isWatched ? 0 : restMilliseconds);
}

void GapJob::cancel() {
  m_work.stop();
  dropCompletion();
  m_wanted.reset();
  m_rest.stop();
}

void GapJob::dropCompletion() {
  m_completion.stop();
  m_incomplete.reset();
}

void GapJob::setWatched(bool watched) {
  if (std::exchange(m_isWatched, watched) == watched) return;
  if (watched && m_rest.isActive()) m_rest.start(0);
}

bool GapJob::setWithReference(bool withReference) {
  if (std::exchange(m_isWithReference, withReference) == withReference) return false;
  m_work.stop();
  return true;
}

void GapJob::start() {
  if (m_work.isAtWork() || !m_wanted) return;
  m_work.start([evaluation = m_wanted, withReference = m_isWithReference](
                   const std::stop_token& stop) { return assessGap(evaluation, stop, withReference); },
               [evaluation = m_wanted](const std::string& reason) {
                 return noGap(evaluation,
                              recorded({PHRASE_LATER("Phrase", "diagnosis"), reason, evaluation->session}));
               });
}

void GapJob::finish(const SharedGap& gap) {
  if (gap->evaluation == m_wanted && !m_work.isStopped()) {
    m_wanted.reset();
    m_incomplete = gap;
    emit assessed(gap);
    complete();
  } else if (!m_rest.isActive()) {
    start();
  }
}

/// Seeks the rows on which the verdict of the delivered gap depends.
void GapJob::complete() {
  if (m_completion.isAtWork() || !m_incomplete) return;
  const SharedGap gap = std::exchange(m_incomplete, nullptr);
  m_completion.start([gap](const std::stop_token& stop) { return withDependences(*gap, stop); },
                     [gap](const std::string&) { return *gap; });
}

}  // namespace alidade::ui
