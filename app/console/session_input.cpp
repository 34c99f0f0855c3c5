#include "app/console/session_input.h"

#include <filesystem>
#include <utility>

#include "app/console/channels.h"
#include "app/console/own_effect_files.h"
#include "core/base/clock.h"
#include "core/base/file_bytes.h"
#include "core/base/sha256.h"
#include "core/base/visible_text.h"
#include "core/session/hindrance.h"
#include "core/session/session_file.h"
#include "core/session/taken_record.h"

namespace alidade::console {

namespace {

Result<SessionInput> sessionInput(SessionRead read, const std::string& file) {
  Session& session = read.session;
  Examined examined = examine(session);
  if (auto problem = firstHindrance(session, examined.problems)) return *std::move(problem);
  for (const Problem& problem : examined.problems) notify(inputName(file), problem.text());
  const std::string name = nameOf(session, file);
  reportOwnEffects(inputName(file), *examined.measurement);
  return SessionInput{name, std::move(session), std::move(examined.measurement).value(),
                      std::move(read.digest)};
}

}  // namespace

Result<SessionRead> readSessionOf(const std::string& file) {
  const Result<std::string> bytes = file == "-" ? readStandardInput() : readFile(file);
  if (!bytes) return bytes.problem();
  Result<Session> session = readSession(*bytes);
  if (!session) return session.problem();
  return SessionRead{*std::move(session), sha256(*bytes)};
}

std::string nameOf(const Session& session, const std::string& file) {
  return session.title.empty() ? wellFormed(std::filesystem::path(inputName(file)).filename().string())
                               : session.title;
}

Result<SessionInput> readSessionInput(const std::string& file, Session (*prepare)(Session),
                                      const std::vector<std::string>& effects) {
  Result<SessionRead> found = readSessionOf(file);
  if (!found) return found.problem();
  SessionRead read = *std::move(found);
  Session& session = read.session;
  if (prepare) session = prepare(std::move(session));
  if (auto problem = addOwnEffects(session, effects)) return *std::move(problem);
  return sessionInput(std::move(read), file);
}

std::optional<Problem> addRecord(Session& session, const std::string& record) {
  const Result<InstrumentRecord> known = loadInstrumentRecord(record);
  if (!known) return Problem{"--instrument " + visibleText(record) + ": " + known.problem().text()};
  const std::string day = session.measuredOn.empty() ? localDay() : session.measuredOn;
  if (!known->due.empty() && known->due < day)
    notify(record, "the next check of the instrument was due on " + known->due + ": check it again");
  return takeRecord(session, *known, wellFormed(std::filesystem::path(record).filename().string()));
}

Result<SessionInput> readSessionInput(const std::string& file, const std::string& record,
                                      const std::vector<std::string>& effects) {
  Result<SessionRead> found = readSessionOf(file);
  if (!found) return found.problem();
  SessionRead read = *std::move(found);
  Session& session = read.session;
  if (!record.empty())
    if (auto problem = addRecord(session, record)) return *std::move(problem);
  if (auto problem = addOwnEffects(session, effects)) return *std::move(problem);
  return sessionInput(std::move(read), file);
}

}  // namespace alidade::console
