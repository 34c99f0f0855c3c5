#include "ui/jobs/outlook_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/evaluation/guide.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

OutlookJob::OutlookJob(QObject* parent)
    : QObject(parent), m_work([this](const SharedOutlook& outlook) {
        const bool isOvertaken = m_wanted || m_isCancelled;
        if (m_wanted) start();
        if (!isOvertaken) emit found(outlook);
      }) {}

void OutlookJob::request(SharedEvaluation evaluation, SharedGap gap, double uncertainty) {
  m_wanted = std::move(evaluation);
  m_gap = std::move(gap);
  m_uncertainty = uncertainty;
  m_isCancelled = false;
  if (m_work.isAtWork())
    m_work.stop();
  else
    start();
}

void OutlookJob::cancel() {
  m_wanted.reset();
  m_isCancelled = true;
  m_work.stop();
}

void OutlookJob::start() {
  const SharedEvaluation evaluation = std::exchange(m_wanted, nullptr);
  m_work.start(
      [evaluation, gap = m_gap, uncertainty = m_uncertainty](const std::stop_token& stop) {
        const Guide& guide = *evaluation->guide;
        const Measurement& measurement = *evaluation->examined.measurement;
        const Diagnosis* const diagnosis = gap ? gap->found() : nullptr;
        OutlookOfSession found{evaluation};
        if (guide.protocol.isByWorth)
          found.ahead = sightingsAhead(measurement, guide.protocol, uncertainty, diagnosis, stop);
        else
          found.outlook =
              outlookOf(measurement, evaluation->fit, diagnosis, guide.protocol, guide.progress, stop);
        return found;
      },
      [evaluation](const std::string& reason) {
        return OutlookOfSession{
            .evaluation = evaluation,
            .failure = reportFailure({PHRASE_LATER("Phrase", "forecast of U"), reason, evaluation->session})};
      });
}

}  // namespace alidade::ui
