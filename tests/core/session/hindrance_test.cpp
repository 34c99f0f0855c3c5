#include "core/session/hindrance.h"

#include <gtest/gtest.h>

#include "core/session/measurement.h"
#include "tests/support/paper_table.h"

namespace alidade::test {
namespace {

std::size_t hindering(const Session& session) {
  const Examined examined = examine(session);
  EXPECT_FALSE(examined.problems.empty());
  return hindrances(session, examined.problems).size();
}

TEST(Hindrance, IsNoDate) {
  Session session = paperSession();
  session.measuredOn = "3/4/2026";
  EXPECT_EQ(hindering(session), 0u);
  session.positions[0].readings[0].vertical = "x";
  EXPECT_EQ(hindering(session), 1u);
  session = paperSession();
  session.instrument.record.date = "soon";
  EXPECT_EQ(hindering(session), 0u);
}

TEST(Hindrance, IsTheTemperatureWhereALengthExpands) {
  for (std::string Environment::*text : {&Environment::temperatureC, &Environment::sigmaTemperatureC}) {
    Session session = paperSession();
    session.environment.*text = "warm";
    EXPECT_EQ(hindering(session), 0u);
    session.geometry.radiusExpansionPpmPerK = "11";
    EXPECT_GE(hindering(session), 1u);
  }
}

TEST(Hindrance, IsALength) {
  Session session = paperSession();
  session.geometry.sigmaRadiusMm = "much";
  EXPECT_EQ(hindering(session), 1u);
}

}  // namespace
}  // namespace alidade::test
