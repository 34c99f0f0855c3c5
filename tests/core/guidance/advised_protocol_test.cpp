#include "core/guidance/advised_protocol.h"

#include <gtest/gtest.h>

#include "tests/core/guidance/simulated.h"

namespace alidade {
namespace {

/// The protocol from readings of a plan is that plan, except for names and unrecorded coordinates.
TEST(ProtocolFromRows, IsThePlanThatWasRead) {
  for (const Protocol& named : namedProtocols()) {
    const Session session = *simulate(named, test::truth(), 3);
    SightingProtocol wanted = templateOf(named);
    for (ProtocolPosition& position : wanted.positions) position.zeros.before = {1};
    const SightingProtocol found = protocolFromRows(session);
    EXPECT_EQ(sightingsInOrder(found), sightingsInOrder(wanted)) << named.name;
    EXPECT_EQ(found.readsSlider, named.slider) << named.name;
    EXPECT_NEAR(circleTurn(found.positions[1]).degrees(), named.circleShift.degrees(), 1e-9) << named.name;
    EXPECT_TRUE(progressOf(session, found).isComplete()) << named.name;
  }
}

TEST(ProtocolFromRows, OfASessionWithoutRowsIsNone) {
  EXPECT_TRUE(protocolFromRows(blankSession()).positions.empty());
}

/// A protocol sights every place in every round: thirty rows would be nine hundred sightings, 10⁵ rows 10¹⁰.
TEST(ProtocolFromRows, OfMoreThanAProtocolHoldsIsNone) {
  Session session = blankSession();
  const auto typeRows = [&](int count) {
    std::vector<Reading>& rows = session.positions.front().readings;
    rows.clear();
    for (int i = 1; i <= count; ++i) {
      Reading row;
      row.point = row.round = std::to_string(i);
      row.horizontal = "10";
      row.vertical = "90";
      rows.push_back(row);
    }
  };
  typeRows(30);
  EXPECT_EQ(sightingCount(protocolFromRows(session)),
            900u * session.positions.size() + session.positions.size());
  typeRows(100'000);
  EXPECT_TRUE(protocolFromRows(session).positions.empty());
}

TEST(WithMeasures, AddsWhatIsAdvised) {
  const SightingProtocol paper = templateOf(*protocolByName("paper"));
  const auto count = [](const SightingProtocol& protocol) { return sightingsInOrder(protocol).size(); };
  ASSERT_EQ(count(paper), 36u);
  EXPECT_EQ(count(withMeasures(paper, {Measure::WayBack})), 36u + 34);
  EXPECT_EQ(count(withMeasures(paper, {Measure::BothFaces})), 2 * 36u);
  EXPECT_EQ(count(withMeasures(paper, {Measure::BothFaces, Measure::WayBack})), 4 + 2 * 68u);
  EXPECT_EQ(count(withMeasures(paper, {Measure::ShiftedCircle})), 2 * 36u);
  EXPECT_EQ(count(withMeasures(paper, {Measure::At0Again})), 36u + 18);
  EXPECT_EQ(count(withMeasures(paper, {Measure::ZeroSightedAgain})), 36u + 2);
  EXPECT_TRUE(withMeasures(paper, {Measure::SliderReadings}).readsSlider);
  EXPECT_NEAR(circleTurn(withMeasures(paper, {Measure::ShiftedCircle}).positions[3]).degrees(), 60, 1e-9);
  EXPECT_EQ(withMeasures(paper, {Measure::SecondStandOff}), paper);
  EXPECT_FALSE(isForProtocol(Measure::SecondStandOff));
  const SightingProtocol back = withMeasures(paper, {Measure::WayBack});
  EXPECT_TRUE(back.positions[0].rounds[1].isBack);
}

TEST(WithMeasures, OfMoreThanAProtocolHoldsIsNone) {
  SightingProtocol protocol = templateOf(test::plan(17, 10, 10, 1));
  ASSERT_EQ(protocol.positions.size(), 2u);
  ProtocolPosition& first = protocol.positions.front();
  first.rounds.assign(290, {});
  ASSERT_LE(sightingCount(protocol), mostSightings);
  EXPECT_FALSE(withMeasures(protocol, {Measure::WayBack}).positions.empty());
  EXPECT_TRUE(withMeasures(protocol, {Measure::At0Again, Measure::BothFaces}).positions.empty());
  EXPECT_TRUE(withMeasures({}, {Measure::WayBack}).positions.empty());
}

TEST(WithMeasures, AddsPlacesWhereThereAreNone) {
  const SightingProtocol part = templateOf(test::plan(5, 60, 20, 1));
  const SightingProtocol whole = withMeasures(part, {Measure::MoreOfTheArc});
  EXPECT_EQ(whole.places.size(), 5u + 12) << "by tens from 10° to 170° but for those there are";
}

}  // namespace
}  // namespace alidade
