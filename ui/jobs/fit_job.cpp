#include "ui/jobs/fit_job.h"

#include <utility>

#include "ui/jobs/failed_job.h"

namespace alidade::ui {

FitJob::FitJob(QObject* parent)
    : QObject(parent),
      m_fit([this](const SharedEvaluation& fitted) { finishFit(fitted); }),
      m_search([this](const std::shared_ptr<const Search>& done) { finishSearch(*done); }) {}

void FitJob::request(const Session& session) {
  m_fitted.reset();
  m_search.stop();
  if (m_fit.isAtWork()) {
    m_next = session;
  } else {
    fit(session);
  }
}

void FitJob::fit(const Session& session) {
  m_fit.start([session](const std::stop_token&) { return evaluateFit(session); },
              [session](const std::string& reason) {
                return failedEvaluation(session, tellFailure({"fit", reason, session}));
              });
}

void FitJob::finishFit(const SharedEvaluation& fitted) {
  if (m_next) {
    fit(*std::exchange(m_next, std::nullopt));
    return;
  }
  if (!fitted->isSearched) m_fitted = fitted;
  emit evaluated(fitted);
  search();
}

void FitJob::search() {
  if (m_search.isAtWork() || !m_fitted) return;
  const auto answer = [fitted = m_fitted](Evaluation searched) {
    return Search{fitted, std::make_shared<const Evaluation>(std::move(searched))};
  };
  m_search.start([answer, fitted = m_fitted](
                     const std::stop_token& stop) { return answer(withSuspects(*fitted, stop)); },
                 [answer, fitted = m_fitted](const std::string& reason) {
                   return answer(withoutSuspects(
                       *fitted, tellFailure({"search for misread readings", reason, fitted->session})));
                 });
}

void FitJob::finishSearch(const Search& done) {
  if (done.fitted == m_fitted) {
    m_fitted.reset();
    emit searched(done.found);
  }
  search();
}

}  // namespace alidade::ui
