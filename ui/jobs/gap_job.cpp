#include "ui/jobs/gap_job.h"

#include <QtConcurrent>
#include <utility>

namespace alidade::ui {

GapJob::GapJob(QObject* parent) : QObject(parent) {
  m_threads.setMaxThreadCount(1);
  m_rest.setSingleShot(true);
  connect(&m_rest, &QTimer::timeout, this, &GapJob::start);
  connect(&m_work, &QFutureWatcherBase::finished, this, &GapJob::finish);
}

GapJob::~GapJob() {
  m_work.disconnect(this);
  m_stop.request_stop();
  m_threads.waitForDone();
}

void GapJob::request(SharedEvaluation evaluation) {
  if (evaluation != m_wanted) m_stop.request_stop();
  m_wanted = std::move(evaluation);
  m_rest.start(m_isWatched ? 0 : restMilliseconds);
}

void GapJob::cancel() {
  m_stop.request_stop();
  m_wanted.reset();
  m_rest.stop();
}

void GapJob::setWatched(bool watched) {
  if (std::exchange(m_isWatched, watched) == watched) return;
  if (watched && m_rest.isActive()) m_rest.start(0);
}

void GapJob::start() {
  if (m_isAtWork || !m_wanted) return;
  m_isAtWork = true;
  m_stop = std::stop_source();
  m_work.setFuture(
      QtConcurrent::run(&m_threads, [evaluation = m_wanted, stop = m_stop.get_token()]() -> SharedGap {
        return std::make_shared<const Gap>(assessGap(evaluation, stop));
      }));
}

void GapJob::finish() {
  m_isAtWork = false;
  const SharedGap gap = m_work.result();
  if (gap->evaluation == m_wanted && !m_stop.stop_requested()) {
    m_wanted.reset();
    emit assessed(gap);
  } else if (!m_rest.isActive()) {
    start();
  }
}

}  // namespace alidade::ui
