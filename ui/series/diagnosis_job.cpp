#include "ui/series/diagnosis_job.h"

#include "core/base/phrase.h"
#include "core/series/shared_causes/diagnose_series.h"
#include "core/session/hindrance.h"
#include "core/session/session_file.h"
#include "core/wording/diagnosis_sentence.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

SeriesAnswer diagnoseTogether(const std::vector<std::string>& files, const std::stop_token& stop,
                              const std::function<void(int done, int total)>& progressed) {
  SeriesAnswer answer;
  std::vector<alidade::SeriesSession> sessions;
  for (const std::string& file : files) {
    if (stop.stop_requested()) return answer;
    Result<Session> session = loadSession(file);
    if (!session) continue;
    Examined examined = examine(*session);
    if (!examined.measurement || !hindrances(*session, examined.problems).empty()) continue;
    answer.files.push_back(file);
    const std::string name = session->title.empty() ? file : session->title;
    sessions.push_back(seriesSession(name, *session, *std::move(examined.measurement)));
    sessions.back().file = file;
  }
  if (sessions.empty()) return answer;
  SeriesOptions options;
  if (progressed)
    options.progress = [&](std::size_t done, std::size_t total) {
      progressed(static_cast<int>(done), static_cast<int>(total));
    };
  auto outcome = diagnoseSeries(sessions, options, stop);
  if (outcome)
    answer.diagnosis = std::make_shared<const SeriesDiagnosis>((*std::move(outcome)).diagnosis);
  else
    answer.reason = problemOf(outcome.problem()).text();
  return answer;
}

SeriesDiagnosisJob::SeriesDiagnosisJob(QObject* parent)
    : QObject(parent), m_work([this](const std::shared_ptr<const SeriesAnswer>& answer) {
        if (!m_next) {
          emit finished(answer);
          return;
        }
        const std::vector<std::string> next = *std::move(m_next);
        m_next.reset();
        begin(next);
      }) {}

void SeriesDiagnosisJob::start(const std::vector<std::string>& files) {
  if (!m_work.isAtWork()) return begin(files);
  m_next = files;
  m_work.stop();
}

void SeriesDiagnosisJob::begin(const std::vector<std::string>& files) {
  m_work.start(
      [this, files](const std::stop_token& stop) {
        return diagnoseTogether(files, stop, [this](int done, int total) { emit progressed(done, total); });
      },
      [](const std::string& reason) {
        return SeriesAnswer{
            {}, {}, reportFailure({PHRASE_LATER("Phrase", "series"), reason, std::nullopt, {}})};
      });
}

}  // namespace alidade::ui
