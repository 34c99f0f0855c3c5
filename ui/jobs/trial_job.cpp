#include "ui/jobs/trial_job.h"

#include <QtConcurrent>
#include <utility>

namespace alidade::ui {

DiagnosedTrial diagnoseTrial(const BlindTrialOptions& options, std::uint64_t seed,
                             const std::stop_token& stop) {
  DiagnosedTrial done;
  Result<BlindTrial> drawn = drawBlindTrial(options, seed);
  if (!drawn) {
    done.problem = drawn.problem().what;
    return done;
  }
  done.trial = *std::move(drawn);
  done.gap = assessGap(std::make_shared<const Evaluation>(evaluateFit(done.trial.session)), stop);
  done.problem = done.gap.reason;
  if (done.gap.diagnosis) done.score = scoreTrial(done.trial.seal, *done.gap.diagnosis);
  return done;
}

TrialJob::TrialJob(QObject* parent) : QObject(parent) {
  m_threads.setMaxThreadCount(1);
  connect(&m_work, &QFutureWatcherBase::finished, this, &TrialJob::finish);
}

TrialJob::~TrialJob() {
  m_work.disconnect(this);
  m_stop.request_stop();
  m_threads.waitForDone();
}

void TrialJob::start(const BlindTrialOptions& options, std::uint64_t seed, int count) {
  const bool isFree = m_work.isFinished();
  m_isStale = !isFree;
  m_stop.request_stop();
  m_options = options;
  m_seed = seed;
  m_left = count;
  if (isFree) next();
}

void TrialJob::stop() {
  m_left = 0;
  m_stop.request_stop();
}

void TrialJob::next() {
  m_stop = std::stop_source();
  m_work.setFuture(QtConcurrent::run(
      &m_threads, [options = m_options, seed = m_seed, stop = m_stop.get_token()]() -> SharedTrial {
        return std::make_shared<const DiagnosedTrial>(diagnoseTrial(options, seed, stop));
      }));
}

void TrialJob::finish() {
  if (m_left == 0) return;
  if (!std::exchange(m_isStale, false)) {
    ++m_seed;
    --m_left;
    emit diagnosed(m_work.result());
  }
  if (m_left > 0) next();
}

}  // namespace alidade::ui
