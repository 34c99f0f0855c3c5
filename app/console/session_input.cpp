#include "app/console/session_input.h"

#include <filesystem>

#include "app/console/channels.h"
#include "core/base/file_bytes.h"
#include "core/base/visible_text.h"
#include "core/session/session_file.h"

namespace alidade::console {

namespace {

Problem firstOf(const std::vector<Problem>& problems) {
  Problem first = problems.front();
  if (problems.size() > 1) first.what += " (and " + std::to_string(problems.size() - 1) + " more)";
  return first;
}

}  // namespace

Result<Session> readSessionOf(const std::string& file) {
  if (file != "-") return loadSession(file);
  const Result<std::string> bytes = readStandardInput();
  if (!bytes) return bytes.problem();
  return readSession(*bytes);
}

std::string nameOf(const Session& session, const std::string& file) {
  return session.title.empty() ? wellFormed(std::filesystem::path(inputName(file)).filename().string())
                               : session.title;
}

Result<SessionInput> readSessionInput(const std::string& file, Session (*prepare)(Session)) {
  Result<Session> session = readSessionOf(file);
  if (!session) return session.problem();
  if (prepare) session = prepare(*std::move(session));
  Examined examined = examine(*session);
  if (!examined.problems.empty()) return firstOf(examined.problems);
  const std::string name = nameOf(*session, file);
  return SessionInput{name, *std::move(session), std::move(examined.measurement).value()};
}

}  // namespace alidade::console
