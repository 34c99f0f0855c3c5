#include "ui/jobs/trial_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/statement/gap.h"
#include "ui/jobs/failed_job.h"

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
  if (done.gap.diagnosis)
    done.score = scoreTrial(done.trial.seal, *done.gap.diagnosis);
  else
    done.problem = reasonForNone(done.gap);
  return done;
}

TrialJob::TrialJob(QObject* parent)
    : QObject(parent), m_work([this](const SharedTrial& trial) { finish(trial); }) {}

/// Stops the running trial of an earlier start, if any; `finish` then begins the first trial of this start.
void TrialJob::start(const BlindTrialOptions& options, std::uint64_t seed, int count) {
  m_options = options;
  m_seed = seed;
  m_left = count;
  m_work.isAtWork() ? m_work.stop() : next();
}

void TrialJob::stop() {
  m_left = 0;
  m_work.stop();
}

void TrialJob::next() {
  m_work.start(
      [options = m_options, seed = m_seed](const std::stop_token& stop) {
        return diagnoseTrial(options, seed, stop);
      },
      [seed = m_seed](const std::string& reason) {
        DiagnosedTrial failed;
        failed.problem = reportFailure({PHRASE_LATER("Phrase", "blind trial"), reason, std::nullopt, seed});
        return failed;
      });
}

void TrialJob::finish(const SharedTrial& trial) {
  if (!m_work.isStopped()) {
    ++m_seed;
    --m_left;
    emit diagnosed(trial);
  }
  if (m_left > 0 && !m_work.isAtWork()) next();
}

}  // namespace alidade::ui
