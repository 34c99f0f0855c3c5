#include <gmock/gmock.h>

#include <QTemporaryDir>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/session/journal_check.h"
#include "core/session/session_file.h"
#include "tests/ui/support.h"
#include "ui/commands/change_positions.h"
#include "ui/commands/change_session.h"
#include "ui/commands/edit_readings.h"
#include "ui/commands/session_commands.h"
#include "ui/document/session_document.h"

// Alters a file with a journal outside the program in many ways, before and after a seal, a revision and a
// further seal. The check names the place of every alteration that the file contradicts, and accepts all
// unaltered files.

namespace alidade::ui {
namespace {

using Json = nlohmann::ordered_json;
using State = CheckedSeal::State;
using testing::Contains;
using testing::Field;
using testing::IsEmpty;

/// The state of the session when it is altered.
enum class Stage { Edited, Sealed, EditedOnce, EditedManyWays, SealedAgain };

class Recorded {
 public:
  explicit Recorded(Stage stage) {
    m_document.startWithRecorded(paperSession());
    type(2, ReadingColumn::Vertical, "88 00 00");
    type(2, ReadingColumn::Vertical, "88 00 01");
    changeField(m_document, {.field = "geometry.distance_mm"}, "2406");
    if (stage == Stage::Edited) return;
    seal("R. Roe");
    if (stage == Stage::Sealed) return;
    type(4, ReadingColumn::Horizontal, "350 00 00");
    if (stage == Stage::EditedOnce) return;
    editManyWays();
    if (stage == Stage::SealedAgain) seal("S. Soe");
  }

  Json json() const { return Json::parse(writeSession(m_document.session())); }

 private:
  void type(std::size_t row, ReadingColumn column, const std::string& text) {
    ReadingsEditor(m_document, 0).setCell({row, column}, text);
  }
  void seal(const std::string& by) { m_document.push(new SealSession(m_document, by)); }

  /// Makes a change of every kind that can be reverted, and reopens the written file before the last two.
  void editManyWays() {
    changeField(m_document, {.field = "notes"}, "");
    changeField(m_document, {.field = "operator"}, "J. Doe");
    ReadingsEditor editor(m_document, 0);
    editor.setExcluded({1, 5}, true);
    editor.insertBlank(3);
    type(3, ReadingColumn::Point, "99");
    type(3, ReadingColumn::Horizontal, "12 00 00");
    editor.remove({6, 7});
    editor.clear({{0, ReadingColumn::Vertical}});
    moveRows(m_document, 0, {8}, 1);
    changeField(m_document, {.position = 1, .field = "pointing_zero.vertical"}, "89 59 59");
    typeKnown(m_document, knownRows(m_document.session()).at(0), knownCells[1], "1.5");
    m_document.startWithRecorded(*readSession(writeSession(m_document.session())));
    type(9, ReadingColumn::Note, "gust");
    editor.setExcluded({1}, false);
  }

  SessionDocument m_document;
};

JournalCheck checked(const Json& json) {
  const Result<Session> session = readSession(json.dump());
  EXPECT_TRUE(session) << session.problem().text();
  return checkJournal(*session);
}

class UnalteredJournal : public ::testing::TestWithParam<Stage> {};

TEST_P(UnalteredJournal, Holds) {
  const JournalCheck check = checked(Recorded(GetParam()).json());
  EXPECT_TRUE(check.holds());
  EXPECT_FALSE(check.broken);
  EXPECT_FALSE(check.backwards);
  for (const JournalContradiction& one : check.contradictions)
    ADD_FAILURE() << one.place << ": told " << one.recorded << ", held " << one.held;
  for (const CheckedSeal& seal : check.seals) EXPECT_EQ(seal.state, State::Held) << seal.seal.revision;
}

constexpr Stage allStages[] = {Stage::Edited, Stage::Sealed, Stage::EditedOnce, Stage::EditedManyWays,
                               Stage::SealedAgain};
INSTANTIATE_TEST_SUITE_P(Stages, UnalteredJournal, ::testing::ValuesIn(allStages));

/// Older files have no copy of the sealed session.
TEST_P(UnalteredJournal, HoldsWithDigestsAlone) {
  Json json = Recorded(GetParam()).json();
  for (Json& entry : json["journal"]) entry.erase("content");
  const JournalCheck check = checked(json);
  EXPECT_TRUE(check.holds());
  for (const CheckedSeal& seal : check.seals) EXPECT_NE(seal.state, State::Changed) << seal.seal.revision;
  if (GetParam() == Stage::EditedOnce) {
    EXPECT_EQ(check.seals.at(0).state, State::Held);
  }
}

struct Alteration {
  const char* name;
  const char* place;  ///< the place to be named; null: another message reports it
  std::function<void(Json&)> alter;
  Stage first = Stage::Sealed;  ///< the first stage that detects it
};

Json& row(Json& json, std::size_t position, std::size_t index) {
  return json["positions"][position]["readings"][index];
}

const std::vector<Alteration>& alterations() {
  static const std::vector<Alteration> all{
      {"ReadingOfNoEntry", "positions[1].readings[7].horizontal",
       [](Json& json) { row(json, 1, 7)["horizontal"] = "1 00 00"; }},
      {"ReadingThatWasChanged", "positions[0].readings[2].vertical",
       [](Json& json) { row(json, 0, 2)["vertical"] = "88 00 02"; }, Stage::Edited},
      {"Distance", "geometry.distance_mm", [](Json& json) { json["geometry"]["distance_mm"] = 2407; },
       Stage::Edited},
      {"Radius", "geometry.radius_mm", [](Json& json) { json["geometry"]["radius_mm"] = 401; }},
      {"Tolerance", "acceptance.tolerance_mm", [](Json& json) { json["acceptance"]["tolerance_mm"] = 9; }},
      {"ToleranceGone", "acceptance.tolerance_mm",
       [](Json& json) { json["acceptance"].erase("tolerance_mm"); }},
      {"Title", "title", [](Json& json) { json["title"] = "Another"; }},
      {"PointingZero", "positions[0].pointing_zero.horizontal",
       [](Json& json) { json["positions"][0]["pointing_zero"]["horizontal"] = "332 00 00"; }},
      {"UnknownKey", "geometry.laid_by", [](Json& json) { json["geometry"]["laid_by"] = "somebody"; }},
      {"Excluded", "positions[1].readings[2].excluded",
       [](Json& json) { row(json, 1, 2)["excluded"] = true; }},
      {"FirstTextAlone", "positions[1].readings[3].as_read.vertical",
       [](Json& json) {
         row(json, 1, 3)["as_read"] = {{"vertical", "1 00 00"}};
       },
       Stage::Edited},
      {"JournalCut", "positions[0].readings[2].as_read.vertical",
       [](Json& json) { json["journal"].erase(json["journal"].begin(), json["journal"].end()); },
       Stage::Edited},
      {"EntryAltered", nullptr, [](Json& json) { json["journal"][0]["from"] = "87 00 00"; }, Stage::Edited},
      {"EntryCutOut", nullptr, [](Json& json) { json["journal"].erase(1); }, Stage::Edited},
      {"EntriesSwapped", nullptr, [](Json& json) { std::swap(json["journal"][0], json["journal"][1]); },
       Stage::Edited},
      {"TimeAltered", nullptr, [](Json& json) { json["journal"][1]["at"] = "2001-01-01T00:00:00Z"; },
       Stage::Edited}};
  return all;
}

using Altered = std::tuple<Stage, std::size_t>;
class AlteredJournal : public ::testing::TestWithParam<Altered> {};

TEST_P(AlteredJournal, DoesNotHoldAndIsNamed) {
  const auto [stage, index] = GetParam();
  const Alteration& alteration = alterations()[index];
  if (stage < alteration.first) GTEST_SKIP() << "nothing in the file speaks of it yet";
  Json json = Recorded(stage).json();
  alteration.alter(json);
  const JournalCheck check = checked(json);
  EXPECT_FALSE(check.holds());
  if (!alteration.place) {
    EXPECT_TRUE(check.broken || check.backwards);
    return;
  }
  EXPECT_THAT(check.contradictions, Contains(Field(&JournalContradiction::place, alteration.place)));
}

INSTANTIATE_TEST_SUITE_P(Ways, AlteredJournal,
                         ::testing::Combine(::testing::ValuesIn(allStages),
                                            ::testing::Range(std::size_t{0}, std::size_t{16})),
                         [](const auto& way) {
                           return std::string(alterations()[std::get<1>(way.param)].name) +
                                  std::to_string(static_cast<int>(std::get<0>(way.param)));
                         });

void remove(SessionDocument& document, const std::vector<std::size_t>& rows) {
  ReadingsEditor(document, 0).remove(rows);
}

// Only the order of the entries separates the deletions: both fall into one second, and the second deletes
// higher rows.
TEST(UnalteredJournalRows, MayBeDeletedInQuickSuccession) {
  SessionDocument document;
  document.startWithRecorded(paperSession());
  document.push(new SealSession(document, "R. Roe"));
  remove(document, {1, 2, 4});
  remove(document, {8, 9, 11});
  EXPECT_TRUE(checkJournal(document.session()).holds());
  EXPECT_EQ(document.session().journal[1].place, "positions[0].readings[4]");
}

/// A sealed session with a deletion of rows that the journal lists in the order of version 0.
Session inEarlierOrder() {
  SessionDocument document;
  document.startWithRecorded(paperSession());
  document.push(new SealSession(document, "R. Roe"));
  remove(document, {1, 2, 4});
  Session session = document.session();
  std::vector<JournalEntry> entries(session.journal.rbegin(), session.journal.rend() - 1);
  session.journal.resize(1);
  for (JournalEntry& entry : entries) {
    entry.at = entries.front().at;
    enterInJournal(session.journal, entry);
  }
  return session;
}

TEST(UnalteredJournalRows, HoldInTheEarlierOrder) {
  const Session session = inEarlierOrder();
  ASSERT_EQ(session.journal[1].place, "positions[0].readings[1]");
  EXPECT_TRUE(checkJournal(session).holds());
}

TEST(UnalteredJournalRows, AreFoundBelowAnEmptyRowThatCameLater) {
  SessionDocument document;
  document.startWithRecorded(paperSession());
  remove(document, {8, 15});
  QTemporaryDir folder;
  ASSERT_FALSE(document.save(folder.filePath(QStringLiteral("s.alidade"))));
  document.undoStack().undo();
  ReadingsEditor(document, 0).insertBlank(1);
  EXPECT_TRUE(checkJournal(document.session()).holds());
}

TEST(AlteredJournalRows, AreNamedAloneInTheEarlierOrder) {
  Session session = inEarlierOrder();
  session.title = "altered";
  EXPECT_THAT(checkJournal(session).contradictions,
              testing::ElementsAre(Field(&JournalContradiction::place, "title")));
}

TEST(AlteredJournalRows, AreNamedAfterASeal) {
  for (const Stage stage : {Stage::Sealed, Stage::EditedOnce, Stage::SealedAgain}) {
    Json gone = Recorded(stage).json(), added = gone, swapped = gone;
    gone["positions"][1]["readings"].erase(5);
    EXPECT_FALSE(checked(gone).holds());
    added["positions"][1]["readings"].push_back(row(added, 1, 0));
    EXPECT_FALSE(checked(added).holds());
    std::swap(row(swapped, 1, 5), row(swapped, 1, 6));
    EXPECT_FALSE(checked(swapped).holds());
  }
}

/// A change outside the program and a second seal: both seals report the change, since the second one sealed
/// a value without an entry.
TEST(AlteredJournalRows, StayNamedWhenSealedAgain) {
  Json json = Recorded(Stage::EditedOnce).json();
  row(json, 1, 7)["horizontal"] = "1 00 00";
  SessionDocument document;
  document.startWithRecorded(*readSession(json.dump()));
  document.push(new SealSession(document, "S. Soe"));
  const JournalCheck check = checkJournal(*readSession(writeSession(document.session())));
  ASSERT_EQ(check.seals.size(), 2u);
  EXPECT_EQ(check.seals[0].state, State::Changed);
  EXPECT_EQ(check.seals[1].state, State::Held);
  EXPECT_FALSE(check.holds());
  EXPECT_THAT(check.contradictions,
              Contains(Field(&JournalContradiction::place, "positions[1].readings[7].horizontal")));
}

/// Without a copy, only the digest shows that something was changed.
TEST(AlteredJournalRows, AreToldByTheDigestAlone) {
  Json json = Recorded(Stage::EditedOnce).json();
  for (Json& entry : json["journal"]) entry.erase("content");
  row(json, 1, 7)["horizontal"] = "1 00 00";
  const JournalCheck check = checked(json);
  EXPECT_EQ(check.seals.at(0).state, State::Changed);
  EXPECT_FALSE(check.holds());
}

}  // namespace
}  // namespace alidade::ui
