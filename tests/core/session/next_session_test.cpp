#include "core/session/next_session.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/session/session_fields.h"

namespace alidade {
namespace {

/// Every field holds its own key.
Session fullSession() {
  Session session = blankSession();
  for (const SessionField& field : sessionFields()) field.at(session) = field.key;
  session.protocol = "{}";
  session.instrument.known = {{.effect = "collimation"}};
  session.instrument.record = {.file = "t2.alidade-instrument"};
  session.device.known = {{.effect = "ellipticity"}};
  session.model.effects = {"gravity_sag"};
  session.ownEffects.emplace_back();
  session.journal.emplace_back();
  session.positions[0].zero.horizontal = "1";
  session.positions[0].readings.emplace_back().horizontal = "1";
  return session;
}

TEST(NextSession, KeepsWhatStaysFromOneDeviceToTheNext) {
  const Session session = fullSession(), next = nextSession(session);
  for (const char* key : {"report.laboratory", "report.customer", "report.authorised_by", "operator", "place",
                          "device.name", "instrument.name", "instrument.certificate",
                          "instrument.sigma_horizontal_arcsec", "geometry.radius_mm", "geometry.zero_is",
                          "acceptance.tolerance_mm", "acceptance.coverage", "model.vertical_angle"})
    EXPECT_EQ(sessionFieldNamed(key)->get(next), key);
  EXPECT_EQ(next.instrument.known, session.instrument.known);
  EXPECT_EQ(next.instrument.record, session.instrument.record);
  EXPECT_EQ(next.protocol, session.protocol);
}

// A number of the last device that remains unnoticed would lead to a wrong result.
TEST(NextSession, BeginsAnewWithWhatIsOfOneMeasurement) {
  const Session next = nextSession(fullSession());
  for (const char* key : {"title", "notes", "measured_on", "report.number", "device.serial",
                          "environment.temperature_c", "geometry.distance_mm", "geometry.sigma_distance_mm",
                          "acceptance.reference_intersection_mm", "acceptance.sigma_reference_mm"})
    EXPECT_EQ(sessionFieldNamed(key)->get(next), "") << key;
  EXPECT_EQ(next.positions, blankSession().positions);
  EXPECT_TRUE(next.device.known.empty());
  EXPECT_TRUE(next.model.effects.empty());
  EXPECT_TRUE(next.ownEffects.empty());
  EXPECT_TRUE(next.journal.empty());
}

}  // namespace
}  // namespace alidade
