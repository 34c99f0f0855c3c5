#include "core/guidance/sightings_to_repeat.h"

#include <gtest/gtest.h>

#include "core/base/angle_text.h"
#include "tests/core/guidance/simulated.h"

namespace alidade {
namespace {

std::vector<SightingsToRepeat> sightingsToRepeatIn(const Session& session, const SightingProtocol& protocol,
                                                   bool searched = true) {
  const Examined examined = examine(session);
  const SessionFit fit = fitSession(*examined.measurement);
  const auto faces = compareFaces(*examined.measurement);
  const std::vector<Suspect> suspects =
      searched ? findSuspects(session, *examined.measurement, fit) : std::vector<Suspect>();
  return sightingsToRepeat({*examined.measurement, fit, faces ? &*faces : nullptr, suspects},
                           progressOf(session, protocol));
}

void shift(std::string& text, double arcseconds) {
  text = formatDms(*parseAngle(text) + Angle::fromArcseconds(arcseconds), 2, AngleSigns::Typewriter);
}

std::size_t rowOf(const Session& session, std::size_t position, int point, int round, int face) {
  const auto& rows = session.positions[position].readings;
  const auto is = [](const std::string& text, int number) {
    return (text.empty() ? 1 : std::stoi(text)) == number;
  };
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (is(rows[i].point, point) && is(rows[i].round, round) && is(rows[i].face, face)) return i;
  ADD_FAILURE() << "no such row";
  return 0;
}

TEST(Repeats, AreNoneInSoundSessions) {
  int named = 0;
  constexpr int sessions = 30;
  for (const char* name : {"two-face", "there-and-back", "paper"})
    for (std::uint64_t seed = 1; seed <= sessions; ++seed)
      named += sightingsToRepeatIn(*simulate(*protocolByName(name), test::truth(), seed),
                                   templateOf(*protocolByName(name)), false)
                       .empty()
                   ? 0
                   : 1;
  // Three comparisons at 1 % each, on an estimated scale: at most 5 in 90 except once in hundreds of such
  // tests.
  EXPECT_LE(named, 7);
}

TEST(Repeats, NameAMisreadReadingAndNothingElseForIt) {
  const Protocol& named = *protocolByName("two-face");
  Session session = *simulate(named, test::truth(), 3);
  const std::size_t row = rowOf(session, 1, 5, 2, 2);
  shift(session.positions[1].readings[row].vertical, 60);
  const SightingProtocol protocol = templateOf(named);
  const std::vector<SightingsToRepeat> allToRepeat = sightingsToRepeatIn(session, protocol);
  ASSERT_EQ(allToRepeat.size(), 1u);
  EXPECT_EQ(allToRepeat[0].reason, SightingsToRepeat::Reason::Misread);
  EXPECT_NEAR(allToRepeat[0].size, 60, 8) << "the noise of 2″, four of it";
  const PlannedSighting planned =
      progressOf(session, protocol).sightings[allToRepeat[0].sightings[0]].planned;
  EXPECT_EQ(planned.axisDeg, 180);
  EXPECT_EQ(planned.point, 5);
  EXPECT_EQ(planned.round, 2);
  EXPECT_EQ(planned.face, 2);
}

/// Constant collimation and index are not a reason for a repeat; a single deviating pair is.
TEST(Repeats, NameFacesThatDifferOtherwiseThanElsewhere) {
  const Protocol& named = *protocolByName("two-face");
  Truth truth = test::truth();
  truth.effects = {{ErrorTerm::Collimation, 30}, {ErrorTerm::VerticalIndex, 40}};
  Session session = *simulate(named, truth, 3);
  const SightingProtocol protocol = templateOf(named);
  EXPECT_TRUE(sightingsToRepeatIn(session, protocol, false).empty());
  shift(session.positions[0].readings[rowOf(session, 0, 9, 1, 2)].horizontal, 30);
  const std::vector<SightingsToRepeat> allToRepeat = sightingsToRepeatIn(session, protocol, false);
  ASSERT_FALSE(allToRepeat.empty());
  EXPECT_EQ(allToRepeat[0].reason, SightingsToRepeat::Reason::FacesDisagree);
  EXPECT_EQ(allToRepeat[0].sightings.size(), 2u);
  EXPECT_EQ(progressOf(session, protocol).sightings[allToRepeat[0].sightings[0]].planned.point, 9);
}

TEST(Repeats, NameAPlaceThatLiesElsewhereOnTheWayBack) {
  const Protocol& named = *protocolByName("there-and-back");
  Session session = *simulate(named, test::truth(), 3);
  shift(session.positions[0].readings[rowOf(session, 0, 9, 2, 1)].vertical, 40);
  const SightingProtocol protocol = templateOf(named);
  const std::vector<SightingsToRepeat> allToRepeat = sightingsToRepeatIn(session, protocol, false);
  ASSERT_EQ(allToRepeat.size(), 1u);
  EXPECT_EQ(allToRepeat[0].reason, SightingsToRepeat::Reason::WaysDisagree);
  EXPECT_EQ(progressOf(session, protocol).sightings[allToRepeat[0].sightings[0]].planned.point, 9);
  // Point 9 is at 90°, where up is outward; a zenith circle reads down.
  EXPECT_LT(allToRepeat[0].size, -25);
}

TEST(Repeats, NameAZeroThatMoved) {
  const Protocol& named = *protocolByName("paper");
  Truth truth = test::truth();
  truth.sightsZerosInFull = true;
  Session session = *simulate(named, truth, 3);
  SightingProtocol protocol = templateOf(named);
  for (ProtocolPosition& position : protocol.positions) position.zeros = {{1, 2}, {1, 2}};
  EXPECT_TRUE(sightingsToRepeatIn(session, protocol, false).empty());
  shift(session.positions[0].zero.after.horizontal, 30);
  shift(session.positions[0].zero.afterInTwo.horizontal, 30);
  const std::vector<SightingsToRepeat> allToRepeat = sightingsToRepeatIn(session, protocol, false);
  ASSERT_FALSE(allToRepeat.empty());
  EXPECT_EQ(allToRepeat[0].reason, SightingsToRepeat::Reason::ZeroMoved);
  EXPECT_EQ(allToRepeat[0].sightings.size(), 2u);
  EXPECT_NEAR(allToRepeat[0].size, 30, 10);
}

}  // namespace
}  // namespace alidade
