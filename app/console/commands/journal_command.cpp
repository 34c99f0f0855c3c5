#include "app/console/commands/journal_command.h"

#include <CLI/CLI.hpp>

#include "app/console/journal_text.h"
#include "app/console/session_input.h"

namespace alidade::console {

void addJournalCommand(CLI::App& app, JournalRequest& request) {
  CLI::App* journal = app.add_subcommand(
      "journal", "What was changed in a session after it stood, and whether its journal is whole.");
  journal->add_option("FILE", request.file, "Session (*.alidade); - reads standard input")->required();
  journal->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runJournal(const JournalRequest& request) {
  const Result<Session> session = readSessionOf(request.file);
  if (!session) return session.problem();
  const std::string name = nameOf(*session, request.file);
  return request.json ? journalJson(name, *session) : journalText(name, *session);
}

}  // namespace alidade::console
