#include "ui/jobs/instrument_job.h"

#include <utility>

#include "core/base/phrase.h"
#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/instrument_check.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

CheckedInstrument checkInstrument(const InstrumentQuestion& question) {
  CheckedInstrument answer;
  std::vector<CheckFile> files;
  for (const InstrumentQuestion::Source& source : question.sources)
    files.push_back({source.name, *source.bytes, source.table});
  if (files.empty()) return answer;
  const Result<CheckReadings> readings = readCheckFiles(files, question.reading);
  if (!readings) {
    answer.problem = readings.problem().text();
    return answer;
  }
  Result<InstrumentCheck> check = checkReadings(*readings, question.stated);
  if (!check) {
    answer.problem = check.problem().text();
    return answer;
  }
  const Result<CheckIdentity> identity = identityOf(question.identity, readings->identity);
  if (!identity) {
    answer.problem = identity.problem().text();
    return answer;
  }
  answer.identity = *identity;
  for (const CheckFile& file : files) answer.sources.push_back(file.name);
  answer.check = *std::move(check);
  answer.findings = checkFindings(*answer.check);
  answer.remarks = readings->remarks;
  return answer;
}

InstrumentJob::InstrumentJob(QObject* parent)
    : QObject(parent), m_work([this](const SharedInstrument& answer) {
        if (!m_next) {
          emit checked(answer);
          return;
        }
        InstrumentQuestion next = *std::exchange(m_next, std::nullopt);
        start(std::move(next));
      }) {}

void InstrumentJob::ask(InstrumentQuestion question) {
  if (m_work.isAtWork())
    m_next = std::move(question);
  else
    start(std::move(question));
}

void InstrumentJob::start(InstrumentQuestion question) {
  m_work.start([question = std::move(question)](const std::stop_token&) { return checkInstrument(question); },
               [](const std::string& reason) {
                 CheckedInstrument failed;
                 failed.problem = reportFailure({PHRASE_LATER("Phrase", "instrument check"), reason});
                 return failed;
               });
}

}  // namespace alidade::ui
