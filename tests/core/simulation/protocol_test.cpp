#include "core/simulation/protocol.h"

#include <gtest/gtest.h>

#include "tests/support/trials.h"

namespace alidade {
namespace {

// The plans of the ray tracer's sessions, row by row, under the same names.
TEST(Protocol, PlansTheRowsOfTheTrials) {
  for (const char* name : {"paper", "paper-slider", "two-face", "full"}) {
    const Protocol* protocol = protocolByName(name);
    ASSERT_NE(protocol, nullptr) << name;
    const Measurement measurement = test::trialMeasurement(name);
    ASSERT_EQ(measurement.arcs.size(), protocol->axes.size());
    for (std::size_t i = 0; i < measurement.arcs.size(); ++i) {
      EXPECT_EQ(measurement.arcs[i].axisDeg, protocol->axes[i]);
      std::vector<PlannedRow> rows;
      for (const Sighting& sighting : measurement.arcs[i].sightings) {
        rows.push_back({sighting.round, sighting.point, sighting.face});
        EXPECT_EQ(sighting.slider.has_value(), protocol->slider) << name;
        // The slider was within some arcminutes of the planned place.
        if (sighting.slider) {
          const double away = (*sighting.slider - plannedPlace(*protocol, sighting.point)).degrees();
          EXPECT_NEAR(away, 0, 0.1);
        }
      }
      EXPECT_EQ(rows, plannedRows(*protocol)) << name;
    }
  }
}

TEST(Protocol, AlternatesTheFacesRoundByRound) {
  Protocol protocol;
  protocol.points = 2;
  protocol.rounds = 2;
  protocol.faces = FacePlan::Alternating;
  EXPECT_EQ(plannedRows(protocol), (std::vector<PlannedRow>{{1, 1, 1}, {1, 2, 1}, {2, 2, 2}, {2, 1, 2}}));
}

TEST(Protocol, IsKnownByItsName) {
  for (const Protocol& protocol : namedProtocols()) {
    EXPECT_EQ(protocolByName(protocol.name), &protocol);
    EXPECT_FALSE(protocol.description.empty());
  }
  EXPECT_EQ(protocolByName("by-ear"), nullptr);
}

}  // namespace
}  // namespace alidade
