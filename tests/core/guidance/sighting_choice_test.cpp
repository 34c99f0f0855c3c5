#include "core/guidance/sighting_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/statement/sighting_choice.h"
#include "tests/core/guidance/simulated.h"

namespace alidade::test {
namespace {

using testing::HasSubstr;

const Protocol& bothFaces() {
  static const Protocol protocol = plan(6, 20, 25, 2, FacePlan::BothAtEachPlace);
  return protocol;
}

SightingProtocol byWorth(const Protocol& protocol) {
  SightingProtocol planned = templateOf(protocol);
  for (ProtocolPosition& position : planned.positions)
    position.zeros = {.before = {1}, .after = {1}, .origin = {}};
  return openOrder(planned);
}

struct Chosen {
  ProtocolProgress progress;
  std::optional<SightingChoice> choice;

  Chosen(const Session& session, const SightingProtocol& protocol) : progress(progressOf(session, protocol)) {
    if (const auto measurement = examine(session).measurement)
      choice = chooseSighting(*measurement, protocol, progress);
  }
  const PlannedSighting& next() const { return progress.sightings[choice->next].planned; }
};

Session readOf(const Protocol& protocol, const Truth& truth) {
  return *simulate(protocol, truth, 5);
}

TEST(SightingChoice, IsAmongThoseLeftInThePositionOrTurnsToTheOther) {
  const SightingProtocol protocol = byWorth(bothFaces());
  const Session whole = readOf(bothFaces(), truth());
  for (const std::size_t rows : {1, 2, 5, 12, 23}) {
    const Chosen chosen(cut(whole, 0, rows), protocol);
    ASSERT_TRUE(chosen.choice) << rows;
    const FollowedSighting& followed = chosen.progress.sightings[chosen.choice->next];
    EXPECT_NE(followed.state, SightingState::Taken) << rows;
    EXPECT_EQ(followed.planned.isZero, followed.planned.axisDeg == 180) << rows;
    for (const std::size_t other : chosen.choice->alternatives) EXPECT_NE(other, chosen.choice->next);
  }
}

TEST(SightingChoice, TurnsTheAxisIfNothingIsLeftThere) {
  const Session whole = readOf(bothFaces(), truth());
  const std::size_t rows = whole.positions[0].readings.size();
  const Chosen chosen(cut(whole, 0, rows), byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  EXPECT_EQ(chosen.next().axisDeg, 180);
  EXPECT_TRUE(chosen.next().isZero) << "the orientation of the turned position comes first";
}

TEST(SightingChoice, MayTurnTheAxisBack) {
  const Session whole = readOf(bothFaces(), truth());
  const std::size_t rows = whole.positions[1].readings.size();
  const Chosen chosen(cut(whole, 1, rows), byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  EXPECT_EQ(chosen.next().axisDeg, 0);
  EXPECT_EQ(chosen.next().repeat, 2);
  EXPECT_EQ(listedOrder(byWorth(bothFaces())).positions.size(), 2u);
}

TEST(SightingChoice, StaysInThePositionThatHasAZeroAlready) {
  Session session = readOf(bothFaces(), truth());
  const PointingZero zero = session.positions[1].zero;
  session = cut(session, 0, 6);
  session.positions[1].zero = zero;
  const Chosen chosen(session, byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  EXPECT_EQ(chosen.next().axisDeg, 180);
  EXPECT_FALSE(chosen.next().isZero);
}

TEST(SightingChoice, FollowsTheOrderBeforeTheFirstReadingAndWithoutAZero) {
  const SightingProtocol protocol = byWorth(bothFaces());
  Session session = cut(readOf(bothFaces(), truth()), 0, 0);
  EXPECT_FALSE(Chosen(session, protocol).choice);
  session = cut(readOf(bothFaces(), truth()), 0, 4);
  session.positions[0].zero = {};
  EXPECT_FALSE(Chosen(session, protocol).choice);
}

TEST(SightingChoice, DoesWithoutAZeroInFaceTwoOnceThereAreReadings) {
  SightingProtocol protocol = byWorth(bothFaces());
  for (ProtocolPosition& position : protocol.positions) position.zeros.before = {1, 2};
  const Session session = cut(readOf(bothFaces(), truth()), 0, 6);
  EXPECT_TRUE(Chosen(session, protocol).choice);
}

/// Both faces name the index error at 0° alone; Δd still needs the readings at 180°.
TEST(SightingChoice, IsNotEnoughBeforeBothPositionsAreRead) {
  Truth tilted = truth();
  tilted.effects = {{ErrorTerm::VerticalIndex, 20}};
  const Chosen chosen(cut(readOf(bothFaces(), tilted), 0, 12), byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  EXPECT_THAT(chosen.choice->soFar.named, testing::Contains("vertical_index"));
  EXPECT_FALSE(isEnough(chosen.choice->soFar));
  EXPECT_EQ(chosen.choice->reason, SightingChoice::Reason::MostInformative);
  EXPECT_EQ(chosen.next().axisDeg, 180);
  SessionSoFar alone = chosen.choice->soFar;
  EXPECT_THAT(enoughSentence(alone), HasSubstr("do not exclude a further cause"));
  alone.enough = Enough::Named;
  EXPECT_THAT(enoughSentence(alone), HasSubstr("needs readings at both positions"));
}

/// Both faces of the first round name the index error. An early place and the zero must still be sighted,
/// because the index error may drift.
TEST(SightingChoice, ReturnsToAnEarlyPlaceAndTheZeroBeforeTheEnd) {
  Truth tilted = truth();
  tilted.effects = {{ErrorTerm::VerticalIndex, 20}};
  const SightingProtocol protocol = byWorth(bothFaces());
  const Session whole = readOf(bothFaces(), tilted);
  Session session = whole;
  for (Position& position : session.positions) {
    std::erase_if(position.readings, [](const Reading& row) { return row.round == "2"; });
    position.zero.after = {};
  }
  const Chosen first(session, protocol);
  ASSERT_TRUE(first.choice);
  ASSERT_EQ(first.choice->soFar.enough, Enough::Named);
  EXPECT_EQ(first.choice->reason, SightingChoice::Reason::EarlyPlace);
  EXPECT_EQ(first.next().point, std::stoi(session.positions[1].readings.front().point));
  EXPECT_EQ(first.next().round, 2);
  EXPECT_EQ(first.next().axisDeg, 180);
  for (const Reading& row : whole.positions[1].readings)
    if (row.round == "2" && std::stoi(row.point) == first.next().point) {
      session.positions[1].readings.push_back(row);
      break;
    }
  const Chosen second(session, protocol);
  ASSERT_TRUE(second.choice);
  EXPECT_EQ(second.choice->reason, SightingChoice::Reason::ClosingZero);
  EXPECT_TRUE(second.next().isZero && second.next().isAfter);
  session.positions[1].zero.after.horizontal = session.positions[1].zero.horizontal;
  session.positions[1].zero.after.vertical = session.positions[1].zero.vertical;
  const Chosen third(session, protocol);
  ASSERT_TRUE(third.choice);
  EXPECT_EQ(third.choice->reason, SightingChoice::Reason::MostInformative);
}

TEST(SightingChoice, IsToldWithWhatMayBeTheCase) {
  const Session session = cut(readOf(bothFaces(), truth()), 0, 9);
  const Chosen chosen(session, byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  const Statement statement = sightingChoiceStatement(*chosen.choice, chosen.progress);
  ASSERT_GE(statement.sentences.size(), 2u);
  EXPECT_THAT(statement.sentences.front(), HasSubstr("is most informative per minute"));
  EXPECT_THAT(enoughSentence(chosen.choice->soFar), HasSubstr("Not enough yet"));
  EXPECT_EQ(statement.rows.front().cells.front(), "No cause");
  double sum = 0;
  for (const WeighedCause& cause : chosen.choice->soFar.causes) sum += cause.probability;
  EXPECT_NEAR(sum, 1, 1e-9);
  for (const std::string& sentence : statement.sentences)
    EXPECT_THAT(sentence, testing::Not(HasSubstr("_"))) << "no identifier reaches a person";
}

/// An index error of face 2 and a collimation: both are named, one below the other.
TEST(SightingChoice, IsToldWithASecondCause) {
  Truth two = truth();
  two.effects = {{ErrorTerm::VerticalIndex, 20}, {ErrorTerm::Collimation, 25}};
  const Chosen chosen(readOf(bothFaces(), two), byWorth(bothFaces()));
  ASSERT_TRUE(chosen.choice);
  ASSERT_FALSE(chosen.choice->soFar.alsoNamed.empty());
  EXPECT_THAT(enoughSentence(chosen.choice->soFar), HasSubstr("two causes are identified"));
  const Statement statement = sightingChoiceStatement(*chosen.choice, chosen.progress);
  ASSERT_GE(statement.rows.size(), 2u);
  EXPECT_FALSE(statement.rows[0].isPart);
  EXPECT_TRUE(statement.rows[1].isPart);
  EXPECT_THAT(statement.rows[1].cells.front(), testing::StartsWith("with "));
}

}  // namespace
}  // namespace alidade::test
