#include "app/console/commands/journal_command.h"

#include <CLI/CLI.hpp>

#include "app/console/journal_text.h"
#include "app/console/session_input.h"

namespace alidade::console {

void addJournalCommand(CLI::App& app, JournalRequest& request) {
  CLI::App* journal = app.add_subcommand(
      "journal",
      "What was changed in a session after it was recorded, and whether its journal and seals hold. "
      "Exit code 1 where they do not.");
  journal->add_option("FILE", request.file, "Session (*.alidade); - reads standard input")->required();
  journal->add_flag("--json", request.json, "Print one JSON document");
}

Result<JournalAnswer> runJournal(const JournalRequest& request) {
  const Result<SessionRead> read = readSessionOf(request.file);
  if (!read) return read.problem();
  const Session& session = read->session;
  const std::string name = nameOf(session, request.file);
  const JournalCheck check = checkJournal(session);
  return JournalAnswer{
      request.json ? journalJson(name, session, check, read->digest) : journalText(name, session, check),
      check.holds()};
}

}  // namespace alidade::console
