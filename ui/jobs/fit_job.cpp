#include "ui/jobs/fit_job.h"

#include <utility>

#include "ui/charts/evaluation_pictures.h"
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
  m_request = std::make_shared<const FitRequest>(std::move(request));
  const auto spare = std::make_shared<std::optional<Spare>>(std::exchange(m_spare, std::nullopt));
  const auto wanted = [request = m_request, before = m_last, spare] {
    if (request->isWhole()) return request->onto({});
    std::optional<Spare> once = std::exchange(*spare, std::nullopt);
    return request->onto(once ? once->onwards->onto(std::move(once->session)) : before->session);
  };
  m_fit.start([wanted](const std::stop_token& stop) { return drawn(evaluateFit(wanted(), stop), stop); },
              [wanted](const std::string& reason) {
                Session session = wanted();
                const std::string failure = tellFailure({QT_TRANSLATE_NOOP("Job", "fit"), reason, session});
                return failedEvaluation(std::move(session), failure);
              });
}

void FitJob::finishFit(const SharedEvaluation& fitted) {
  SharedEvaluation before = std::exchange(m_last, fitted);
  if (m_next) {
    keepSpare(std::move(before));
    fit(*std::exchange(m_next, std::nullopt));
    return;
  }
  if (!fitted->isSearched) m_fitted = fitted;
  emit evaluated(fitted);
  keepSpare(std::move(before));
  search();
}

/// Keeps the previous session if nothing else uses the previous evaluation.
void FitJob::keepSpare(SharedEvaluation before) {
  m_spare.reset();
  if (!before || m_request->isWhole()) return;
  if (std::unique_ptr<Evaluation> old = takenBack(std::move(before))) {
    m_spare = Spare{std::move(old->session), m_request};
    sharedAside(std::move(*old));
  }
}

void FitJob::search() {
  if (m_search.isAtWork() || !m_fitted) return;
  const auto answer = [fitted = m_fitted](Evaluation searched) {
    return Search{fitted, sharedAside(std::move(searched))};
  };
  m_search.start(
      [answer, fitted = m_fitted](const std::stop_token& stop) {
        std::optional<Evaluation> found = copyWithSuspects(*fitted, stop);
        return found ? answer(*std::move(found)) : Search{fitted, nullptr};
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
  if (done.found && done.fitted == m_fitted) {
    m_fitted.reset();
    emit searched(done.found);
  }
  search();
}

}  // namespace alidade::ui
