#include "ui/jobs/simulation_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

bool measuresAlike(const Session& one, const Session& other) {
  const Instrument &a = one.instrument, &b = other.instrument;
  return a.sigmaHorizontalArcsec == b.sigmaHorizontalArcsec &&
         a.sigmaVerticalArcsec == b.sigmaVerticalArcsec && a.sigmaZeroArcsec == b.sigmaZeroArcsec &&
         a.sigmaSliderArcsec == b.sigmaSliderArcsec && one.geometry == other.geometry &&
         one.acceptance.coverage == other.acceptance.coverage && one.model == other.model &&
         one.positions == other.positions;
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
