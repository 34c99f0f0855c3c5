#include "ui/jobs/simulation_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/session/session_fields.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

bool measuresAlike(const Session& one, const Session& other) {
  if (one.positions != other.positions) return false;  // most edits differ here, which saves the copy
  Session same = one;
  same.protocol = other.protocol;
  same.acceptance = other.acceptance;
  same.acceptance.coverage = one.acceptance.coverage;
  return isSameMeasurement(same, other);
}

bool BudgetCheck::isOf(const Session& session) const {
  return measuresAlike(evaluation->session, session);
}

SimulationJob::SimulationJob(QObject* parent)
    : QObject(parent), m_work([this](const SharedBudgetCheck& check) { emit finished(check); }) {}

void SimulationJob::start(const SharedEvaluation& evaluation, std::size_t draws) {
  if (isAtWork()) return;
  m_made = 0;
  MonteCarloOptions options{.made = &m_made};
  if (draws > 0) options.draws = draws;
  m_work.start(
      [evaluation, options](const std::stop_token& stop) {
        return BudgetCheck{evaluation, propagateDistributions(*evaluation->examined.measurement,
                                                              evaluation->fit, options, stop)};
      },
      [evaluation, seed = options.seed](const std::string& reason) {
        return BudgetCheck{
            evaluation, std::nullopt,
            reportFailure({PHRASE_LATER("Phrase", "simulation"), reason, evaluation->session, seed})};
      });
}

}  // namespace alidade::ui
