#include "ui/jobs/fit_job.h"

#include <QtConcurrent>
#include <utility>

namespace alidade::ui {

FitJob::FitJob(QObject* parent) : QObject(parent) {
  m_threads.setMaxThreadCount(2);  // one for fits, one for searches
  connect(&m_fit, &QFutureWatcherBase::finished, this, &FitJob::finishFit);
  connect(&m_search, &QFutureWatcherBase::finished, this, &FitJob::finishSearch);
}

FitJob::~FitJob() {
  m_fit.disconnect(this);
  m_search.disconnect(this);
  m_stop.request_stop();
  m_threads.waitForDone();
}

void FitJob::request(const Session& session) {
  m_fitted.reset();
  m_stop.request_stop();
  if (m_fitting) {
    m_next = session;
  } else {
    fit(session);
  }
}

void FitJob::fit(const Session& session) {
  m_fitting = true;
  m_fit.setFuture(QtConcurrent::run(&m_threads, [session]() -> SharedEvaluation {
    return std::make_shared<const Evaluation>(evaluateFit(session));
  }));
}

void FitJob::finishFit() {
  if (m_next) {
    fit(*std::exchange(m_next, std::nullopt));
    return;
  }
  m_fitting = false;
  const SharedEvaluation fitted = m_fit.result();
  if (!fitted->isSearched) m_fitted = fitted;
  emit evaluated(fitted);
  search();
}

void FitJob::search() {
  if (m_searching || !m_fitted) return;
  m_searching = true;
  m_stop = std::stop_source();
  m_search.setFuture(
      QtConcurrent::run(&m_threads, [fitted = m_fitted, stop = m_stop.get_token()]() -> Search {
        return {fitted, std::make_shared<const Evaluation>(withSuspects(*fitted, stop))};
      }));
}

void FitJob::finishSearch() {
  m_searching = false;
  const Search done = m_search.result();
  if (done.fitted == m_fitted) {
    m_fitted.reset();
    emit searched(done.found);
  }
  search();
}

}  // namespace alidade::ui
