#include "ui/jobs/fit_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/base/threads.h"
#include "ui/charts/arc/arc_picture.h"
#include "ui/charts/plotting/evaluation_pictures.h"
#include "ui/charts/residuals/residual_picture.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

namespace {

/// Adds the pictures to the evaluation, unless a stop was requested.
Evaluation drawn(Evaluation evaluation, const std::stop_token& stop) {
  if (stop.stop_requested()) return evaluation;
  auto pictures = std::make_shared<EvaluationPictures>();
  const auto& measurement = evaluation.examined.measurement;
  doAll(threadsFor(measurement ? measurement->rows : 0),
        {[&] { pictures->arcs = arcPictureOf(evaluation); },
         [&] { pictures->residuals = residualPictureOf(evaluation); }});
  evaluation.pictures = std::move(pictures);
  return evaluation;
}

}  // namespace

FitJob::FitJob(QObject* parent)
    : QObject(parent),
      m_fit([this](const SharedEvaluation& fitted) { finishFit(fitted); }),
      m_search([this](const std::shared_ptr<const Search>& done) { finishSearch(*done); }) {}

void FitJob::request(Session session) {
  m_fitted.reset();
  m_search.stop();
  if (m_fit.isAtWork()) {
    m_next = std::move(session);
    m_fit.stop();
  } else {
    fit(std::move(session));
  }
}

void FitJob::fit(Session session) {
  const auto wanted = std::make_shared<const Session>(std::move(session));
  m_fit.start([wanted](const std::stop_token& stop) { return drawn(evaluateFit(*wanted, stop), stop); },
              [wanted](const std::string& reason) {
                return failedEvaluation(*wanted, recorded({PHRASE_LATER("Phrase", "fit"), reason, *wanted}));
              });
}

void FitJob::finishFit(const SharedEvaluation& fitted) {
  if (m_next) return fit(*std::exchange(m_next, std::nullopt));
  if (!fitted->isSearched) m_fitted = fitted;
  emit evaluated(fitted);
  search();
}

void FitJob::search() {
  if (m_search.isAtWork() || !m_fitted) return;
  const auto answer = [fitted = m_fitted](Evaluation searched) {
    return Search{fitted, std::make_shared<const Evaluation>(std::move(searched))};
  };
  m_search.start(
      [answer, fitted = m_fitted](const std::stop_token& stop) {
        std::optional<Evaluation> found = copyWithSuspects(*fitted, stop);
        return found ? answer(*std::move(found)) : Search{fitted, nullptr};
      },
      [answer, fitted = m_fitted](const std::string& reason) {
        return answer(withoutSuspects(
            *fitted,
            recorded({PHRASE_LATER("Phrase", "search for misread readings"), reason, fitted->session})));
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
