#include "ui/jobs/simulation_job.h"

#include <QtConcurrent>
#include <utility>

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

SimulationJob::SimulationJob(QObject* parent) : QObject(parent) {
  m_threads.setMaxThreadCount(1);
  connect(&m_work, &QFutureWatcherBase::finished, this, &SimulationJob::finish);
}

SimulationJob::~SimulationJob() {
  m_work.disconnect(this);
  m_stop.request_stop();
  m_threads.waitForDone();
}

void SimulationJob::start(SharedEvaluation evaluation, std::size_t draws) {
  if (std::exchange(m_isAtWork, true)) return;
  m_stop = std::stop_source();
  m_made = 0;
  m_work.setFuture(QtConcurrent::run(&m_threads,
                                     [evaluation = std::move(evaluation), draws, made = &m_made,
                                      stop = m_stop.get_token()]() -> SharedBudgetCheck {
                                       return std::make_shared<const BudgetCheck>(
                                           evaluation, propagateDistributions(
                                                           *evaluation->examined.measurement, evaluation->fit,
                                                           {.draws = draws, .made = made}, stop));
                                     }));
}

void SimulationJob::stop() {
  m_stop.request_stop();
}

void SimulationJob::finish() {
  m_isAtWork = false;
  emit finished(m_work.result());
}

}  // namespace alidade::ui
