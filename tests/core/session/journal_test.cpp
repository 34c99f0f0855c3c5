#include "core/session/journal.h"

#include <gtest/gtest.h>

#include <regex>

#include "core/session/session_file.h"
#include "core/wording/journal.h"

namespace alidade {
namespace {

JournalEntry change(const std::string& from, const std::string& to) {
  return {.at = "2026-03-14T15:09:26Z",
          .by = "J. Doe",
          .place = "positions[0].readings[4].vertical",
          .axis = "0",
          .point = "5",
          .from = from,
          .to = to,
          .why = journal_reasons::retyped};
}

Session journalled() {
  Session session = blankSession();
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  Reading& row = session.positions[0].readings.emplace_back();
  row.point = "5";
  row.horizontal = "341 52 24";
  row.vertical = "88°";
  row.asRead.set("vertical", "88,5");
  row.asRead.set("point", "4");
  enterInJournal(session.journal, change("1\n\"2\"", "341°52'24\""));
  enterInJournal(session.journal, change("341°52'24\"", ""));
  return session;
}

Session reread(const Session& session) {
  return *readSession(writeSession(session));
}

TEST(Journal, HashesAreThoseOfACompactListByAnotherProgram) {
  // python3: h = ""; hashlib.sha256(json.dumps([h, *texts], ensure_ascii=False, separators=(",", ":"))
  // .encode()).hexdigest()
  const Session session = journalled();
  EXPECT_EQ(session.journal[0].hash, "ce823f366afeaf9cd290adf9d7c597938290d528144c72426c8904c4c6637559");
  EXPECT_EQ(session.journal[1].hash, "4d9bf705be4bf1a145e578c232cdf783f9aaa6645e811b329485d7c536635bbb");
}

TEST(Journal, KeepsAReasonStatedAfterTheChangesItIsOf) {
  Session session = journalled();
  enterInJournal(session.journal, change("1", "2"));
  enterInJournal(session.journal, explainingEntry(session.journal, 1, 2, "digits exchanged"));
  EXPECT_EQ(session.journal.back().place, session.journal[1].place);
  EXPECT_EQ(explanationOf(session.journal, 0), "");
  EXPECT_EQ(explanationOf(session.journal, 1), "digits exchanged");
  EXPECT_EQ(explanationOf(session.journal, 2), "digits exchanged");
  EXPECT_EQ(explanationOf(session.journal, 3), "") << "the reason itself needs none";
  EXPECT_EQ(reasonText(session.journal[2], session), "retyped: digits exchanged");
  EXPECT_EQ(reasonText(session.journal[0], session), "retyped");
  enterInJournal(session.journal, explainingEntry(session.journal, 2, 1, "misheard"));
  EXPECT_EQ(explanationOf(session.journal, 1), "digits exchanged");
  EXPECT_EQ(explanationOf(session.journal, 2), "misheard") << "the last one stated";
  EXPECT_FALSE(firstBrokenEntry(reread(session).journal));
}

TEST(Journal, AReasonIsNoChangeSinceASeal) {
  Session session = blankSession();
  enterInJournal(session.journal, change("", "2404"));
  session.journal.back().place = "geometry.distance_mm";
  EXPECT_EQ(sealState(session.journal), "");
  enterInJournal(session.journal, sealingEntry(session, "R. Roe", "2026-03-15T08:00:00Z"));
  EXPECT_EQ(sealState(session.journal), "Sealed 2026-03-15 08:00 UTC by R. Roe");
  JournalEntry later = change("", "2405");
  later.place = "geometry.distance_mm";
  enterInJournal(session.journal, later);
  session.geometry.distanceMm = "2405";
  enterInJournal(session.journal, explainingEntry(session.journal, 2, 1, "tape read anew"));
  EXPECT_EQ(changesSince(*sealOf(session.journal), session.journal), 1u);
  EXPECT_EQ(sealState(session.journal),
            "Sealed 2026-03-15 08:00 UTC by R. Roe, with one unsealed change since");
  const JournalCheck check = checkJournal(session);
  ASSERT_EQ(check.seals.size(), 1u);
  EXPECT_EQ(check.seals[0].state, CheckedSeal::State::Held) << "the reason hides no change";
}

TEST(Journal, SurvivesAFileWithItsFirstTexts) {
  const Session session = journalled();
  const Session back = reread(session);
  EXPECT_EQ(back.journal, session.journal);
  EXPECT_FALSE(firstBrokenEntry(back.journal));
  EXPECT_EQ(back.positions[0].readings[0].asRead.of("vertical"), "88,5");
  EXPECT_EQ(writeSession(back), writeSession(session));
  EXPECT_EQ(changedReadings(back), 2U);
}

TEST(Journal, LeavesNothingInTheFileWhereThereIsNone) {
  Session session = journalled();
  session.journal.clear();
  session.positions[0].readings[0].asRead = {};
  const std::string text = writeSession(session);
  EXPECT_EQ(text.find("journal"), std::string::npos);
  EXPECT_EQ(text.find("as_read"), std::string::npos);
  Session taken = reread(journalled());
  taken.journal.clear();
  taken.positions[0].readings[0].asRead.drop("vertical");
  taken.positions[0].readings[0].asRead.drop("point");
  EXPECT_EQ(writeSession(taken).find("as_read"), std::string::npos) << "taken out of what was read";
}

/// Changing any text of any entry, or removing an entry, is detected and located.
TEST(Journal, ShowsEveryChangeOfALine) {
  std::vector<JournalEntry> journal;
  for (int i = 0; i < 6; ++i) enterInJournal(journal, change(std::to_string(i), std::to_string(i + 1)));
  ASSERT_FALSE(firstBrokenEntry(journal));
  for (std::string JournalEntry::*text :
       {&JournalEntry::at, &JournalEntry::by, &JournalEntry::place, &JournalEntry::axis, &JournalEntry::point,
        &JournalEntry::round, &JournalEntry::face, &JournalEntry::from, &JournalEntry::to, &JournalEntry::why,
        &JournalEntry::hash})
    for (std::size_t i = 0; i < journal.size(); ++i) {
      auto changed = journal;
      changed[i].*text += "x";
      EXPECT_EQ(firstBrokenEntry(changed), i);
    }
  for (std::size_t i = 0; i + 1 < journal.size(); ++i) {
    auto shorter = journal;
    shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(firstBrokenEntry(shorter), i);
  }
}

TEST(Journal, SealsWhatTheSessionSays) {
  Session session = journalled();
  auto& rows = session.positions[0].readings;
  rows[0].asRead = {};
  rows.insert(rows.begin(), 4, rows[0]);
  EXPECT_FALSE(sealOf(session.journal));
  enterInJournal(session.journal, sealingEntry(session, "R. Roe", "2026-03-15T08:00:00Z"));
  Session back = reread(session);
  auto seal = sealOf(back.journal);
  ASSERT_TRUE(seal);
  EXPECT_EQ(seal->by, "R. Roe");
  EXPECT_EQ(seal->revision, 0);
  EXPECT_TRUE(isAsSealed(back, *seal)) << "as in the file";
  EXPECT_EQ(journalSummary(back), "Sealed 2026-03-15 08:00 UTC by R. Roe and unchanged since.");

  back.positions[0].readings[4].vertical = "89°";
  EXPECT_FALSE(isAsSealed(back, *seal));
  EXPECT_NE(journalSummary(back).find("differs from what was sealed, and the journal does not record"),
            std::string::npos);
  enterInJournal(back.journal, change("88°", "89°"));
  EXPECT_NE(journalSummary(back).find("; one change since: the current revision is not sealed."),
            std::string::npos);

  enterInJournal(back.journal, sealingEntry(back, "R. Roe", "2026-03-16T08:00:00Z"));
  seal = sealOf(back.journal);
  EXPECT_EQ(seal->revision, 1);
  EXPECT_TRUE(isAsSealed(back, *seal));
}

TEST(Journal, TellsOfAChainThatIsBroken) {
  std::string text = writeSession(journalled());
  text = std::regex_replace(text, std::regex("J. Doe"), "K. Doe", std::regex_constants::format_first_only);
  EXPECT_NE(journalSummary(*readSession(text)).find("is broken from entry 1 on"), std::string::npos);
}

TEST(Journal, RefusesWhatIsNoEntry) {
  const std::string whole = writeSession(journalled());
  const std::string wrong = std::regex_replace(whole, std::regex("\"by\": \"J. Doe\""), "\"by\": 7");
  const auto session = readSession(wrong);
  ASSERT_FALSE(session);
  EXPECT_EQ(session.problem().where.path(), "journal[0].by");
}

}  // namespace
}  // namespace alidade
