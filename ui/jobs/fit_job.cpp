#include "ui/jobs/fit_job.h"

#include <QtConcurrent>
#include <utility>

namespace alidade::ui {

FitJob::FitJob(QObject* parent) : QObject(parent) {
  connect(&m_watcher, &QFutureWatcherBase::finished, this, &FitJob::finish);
}

FitJob::~FitJob() {
  m_watcher.disconnect(this);
  m_watcher.waitForFinished();
}

void FitJob::request(const Session& session) {
  if (m_running) {
    m_next = session;
  } else {
    start(session);
  }
}

void FitJob::start(const Session& session) {
  m_running = true;
  m_watcher.setFuture(QtConcurrent::run(
      [session]() -> SharedEvaluation { return std::make_shared<const Evaluation>(evaluate(session)); }));
}

void FitJob::finish() {
  if (m_next) {
    start(*std::exchange(m_next, std::nullopt));
    return;
  }
  m_running = false;
  emit evaluated(m_watcher.result());
}

}  // namespace alidade::ui
