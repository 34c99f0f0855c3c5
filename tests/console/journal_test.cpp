#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/session/session_file.h"
#include "tests/console/console.h"

// `alidade-cli journal`: recorded changes of a session.

namespace alidade::test {
namespace {

using Json = nlohmann::ordered_json;
using testing::ContainsRegex;
using testing::HasSubstr;

std::string sealedSession() {
  Session session = *loadSession(paperSession);
  enterInJournal(session.journal, {.at = "2026-03-14T15:09:26Z",
                                   .by = "J. Doe\x1b[31m",
                                   .place = "positions[0].readings[4].vertical",
                                   .axis = "0",
                                   .point = "5",
                                   .from = "82°30'39\"",
                                   .to = "82°40'39\"",
                                   .why = "suggestion"});
  enterInJournal(session.journal, sealingEntry(session, "R. Roe", "2026-03-15T08:00:00Z"));
  return writeSession(session);
}

ProgramRun journalOf(const std::string& session, const std::vector<std::string>& options = {}) {
  std::vector<std::string> arguments{"journal", "-"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return runProgram({.program = ALIDADE_CLI, .arguments = arguments, .input = session});
}

TEST(JournalCommand, ListsTheChangesAndTheSeal) {
  const ProgramRun run = journalOf(sealedSession());
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("2026-03-14 15:09 +positions.0..readings.4..vertical \\(point 5\\) +"
                                     "suggestion accepted +J. Doe.u001b.31m +82°30'39\" +82°40'39\"\n"));
  EXPECT_THAT(run.out, HasSubstr("Sealed 2026-03-15 08:00 UTC by R. Roe and unchanged since."));
  const std::string digest = sealOf(readSession(sealedSession())->journal)->digest;
  EXPECT_THAT(run.out, HasSubstr(digest)) << "whole, to be quoted";
  const Json json = Json::parse(journalOf(sealedSession(), {"--json"}).out);
  EXPECT_EQ(json["whole"], true);
  EXPECT_EQ(json["sealed"]["unchanged"], true);
  EXPECT_EQ(json["entries"].size(), 2U);
  EXPECT_EQ(json["entries"][0]["to"], "82°40'39\"");
}

TEST(JournalCommand, TellsWhatTheJournalDoesNot) {
  std::string text = sealedSession();
  const auto at = text.find("341");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 3, "342");
  const ProgramRun run = journalOf(text, {"--json"});
  EXPECT_EQ(run.exitCode, 1);
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["whole"], false);
  EXPECT_EQ(json["sealed"]["unchanged"], false);
  EXPECT_EQ(json["seals"][0]["state"], "changed");
  ASSERT_EQ(json["contradictions"].size(), 1U);
  EXPECT_EQ(json["contradictions"][0]["place"], "positions[0].readings[0].horizontal");
  EXPECT_THAT(journalOf(text).out, HasSubstr("positions[0].readings[0].horizontal: the journal says"));
}

TEST(JournalCommand, SaysWhereNothingWasChanged) {
  const ProgramRun run = alidadeCli({"journal", paperSession});
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_THAT(run.out, HasSubstr("No entry was changed after it was recorded."));
}

}  // namespace
}  // namespace alidade::test
