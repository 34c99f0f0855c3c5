#include "core/adjustment/result/expected_reading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/angle_text.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "tests/support/trials.h"

namespace alidade {
namespace {

/// The session before the row was typed.
std::optional<ExpectedReading> beforeRow(const Session& session, std::size_t position, std::size_t row) {
  Session typed = session;
  typed.positions[position].readings.resize(row);
  for (std::size_t later = position + 1; later < typed.positions.size(); ++later)
    typed.positions[later].readings.clear();
  const Examined examined = examine(typed);
  if (!examined.measurement) return {};
  const Reading& next = session.positions[position].readings[row];
  const auto number = [](const std::string& text) { return text.empty() ? 1 : std::stoi(text); };
  const SightingToCome sighting{position, number(next.point), number(next.round), number(next.face)};
  return expectedReadings(*examined.measurement, fitSession(*examined.measurement), {sighting}).front();
}

/// The deviation of either circle from its expected reading.
Angle missOf(const ExpectedReading& expected, const Reading& read) {
  const auto miss = [](Angle angle, const std::string& typed) {
    return std::abs(wrapped(*parseAngle(typed) - angle).radians());
  };
  return Angle::fromRadians(
      std::max(miss(expected.horizontal, read.horizontal), miss(expected.vertical, read.vertical)));
}

/// `step`: the smallest from point to point. A reading one place off is detected.
void expectEveryReadingFromTheFourthOn(const Session& session, Angle step) {
  for (std::size_t position = 0; position < 2; ++position)
    for (std::size_t row = 0; row < 17; ++row) {
      const auto expected = beforeRow(session, position, row);
      ASSERT_EQ(expected.has_value(), position == 1 || row >= 3) << position << " " << row;
      if (!expected) continue;
      const Angle miss = missOf(*expected, session.positions[position].readings[row]);
      EXPECT_LT(miss, expected->tolerance) << position << " " << row;
      EXPECT_LT(expected->tolerance, step);
    }
}

TEST(ExpectedReading, IsNearEveryReadingOfThePaperFromTheFourthOn) {
  expectEveryReadingFromTheFourthOn(test::paperSession(), Angle::fromDegrees(1.3));
}

// 17 places from 140° to 220°, 5° of the slider apart, which is at least 1° at the theodolite.
TEST(ExpectedReading, IsNearEveryReadingAcrossHalfATurn) {
  Protocol protocol = *protocolByName("paper");
  protocol.first = Angle::fromDegrees(140);
  protocol.step = Angle::fromDegrees(5);
  expectEveryReadingFromTheFourthOn(*simulate(protocol, drawTruth(3), 3), Angle::fromDegrees(1));
}

/// Readings of a session simulated by another program with known truth are never called significant, except
/// those deliberately misread.
TEST(ExpectedReading, ToleratesEveryReadingOfTheTrialsAsTheyAreTaken) {
  int known = 0, unknown = 0;
  for (const test::Trial& trial : test::trials()) {
    if (trial.kind == "misread") continue;
    const Session session =
        *loadSession(std::string(ALIDADE_REFERENCE_DIR) + "/trials/sessions/" + trial.id + ".alidade");
    for (std::size_t position = 0; position < session.positions.size(); ++position)
      for (std::size_t row = 0; row < session.positions[position].readings.size(); row += 5) {
        const auto expected = beforeRow(session, position, row);
        ++(expected ? known : unknown);
        if (!expected) continue;
        EXPECT_LT(missOf(*expected, session.positions[position].readings[row]), expected->tolerance)
            << trial.id << " " << position << " " << row;
      }
  }
  EXPECT_GT(known, 4 * unknown);
}

}  // namespace
}  // namespace alidade
