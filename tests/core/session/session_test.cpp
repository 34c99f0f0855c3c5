#include "core/session/session.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/session/measurement.h"
#include "core/session/session_file.h"

namespace alidade {
namespace {

TEST(Session, IsBlankButForBothPositionsAndTheUsualSettings) {
  const Session session = blankSession();
  ASSERT_EQ(session.positions.size(), 2u);
  EXPECT_EQ(session.positions[0].axisDeg, "0");
  EXPECT_EQ(session.positions[1].axisDeg, "180");
  EXPECT_TRUE(session.positions[0].readings.empty());
  EXPECT_EQ(session.instrument.sigmaHorizontalArcsec, "2");
  EXPECT_TRUE(session.geometry.distanceMm.empty());
}

TEST(Session, NeedsOnlyItsRequiredEntriesToBecomeSound) {
  Session session = blankSession();
  EXPECT_EQ(examine(session).problems.size(), 6u) << "L, R0 and two pointing zeros";
  session.geometry.distanceMm = "2405";
  session.geometry.radiusMm = "400";
  for (Position& position : session.positions)
    position.zero = {.horizontal = "10 00 00", .vertical = "90 00 00", .origin = {}};
  const Examined examined = examine(session);
  EXPECT_TRUE(examined.problems.empty()) << examined.problems.front().text();
  EXPECT_TRUE(examined.measurement);
}

TEST(JsonOrigin, CarriesNoMeaningOfItsOwn) {
  Session read = *readSession(writeSession(blankSession()));
  EXPECT_FALSE(read.origin.object().empty());
  EXPECT_EQ(read, blankSession());
  EXPECT_TRUE(blankSession().origin.object().empty());
  read.title = "x";
  EXPECT_NE(read, blankSession());
}

}  // namespace
}  // namespace alidade
