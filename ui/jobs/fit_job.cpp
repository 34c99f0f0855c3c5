#include "ui/jobs/fit_job.h"

#include <utility>

#include "ui/jobs/failed_job.h"

namespace alidade::ui {

FitJob::FitJob(QObject* parent)
    : QObject(parent),
      m_fit([this](const SharedEvaluation& fitted) { finishFit(fitted); }),
      m_search([this](const std::shared_ptr<const Search>& done) { finishSearch(*done); }) {}

void FitJob::request(const Session& session) {
  m_next.emplace(session);
  begin();
}

void FitJob::request(const Session& session, const SessionChange& change) {
  const bool hasGround = m_next || m_last || m_fit.isAtWork();
  if (!hasGround)
    m_next.emplace(session);
  else if (m_next)
    m_next->add(session, change);
  else
    m_next.emplace(session, change);
  begin();
}

void FitJob::begin() {
  m_fitted.reset();
  m_search.stop();
  if (m_fit.isAtWork())
    m_fit.stop();
  else
    fit(*std::exchange(m_next, std::nullopt));
}

void FitJob::fit(FitRequest request) {
  const auto wanted = [request = std::make_shared<const FitRequest>(std::move(request)),
                       before = std::exchange(m_last, nullptr)] {
    return request->session(before ? &before->session : nullptr);
  };
  m_fit.start([wanted](const std::stop_token& stop) { return evaluateFit(wanted(), stop); },
              [wanted](const std::string& reason) {
                Session session = wanted();
                const std::string failure = tellFailure({QT_TRANSLATE_NOOP("Job", "fit"), reason, session});
                return failedEvaluation(std::move(session), failure);
              });
}

void FitJob::finishFit(const SharedEvaluation& fitted) {
  m_last = fitted;
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
    return Search{fitted, sharedAside(std::move(searched))};
  };
  m_search.start(
      [answer, fitted = m_fitted](const std::stop_token& stop) {
        return answer(withSuspects(*fitted, stop));
      },
      [answer, fitted = m_fitted](const std::string& reason) {
        return answer(withoutSuspects(
            *fitted,
            tellFailure({QT_TRANSLATE_NOOP("Job", "search for misread readings"), reason, fitted->session})));
      });
}

void FitJob::stopSearch() {
  m_fitted.reset();
  m_search.stop();
}

void FitJob::finishSearch(const Search& done) {
  if (done.fitted == m_fitted) {
    m_fitted.reset();
    emit searched(done.found);
  }
  search();
}

}  // namespace alidade::ui
