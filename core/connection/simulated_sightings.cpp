#include "core/connection/simulated_sightings.h"

#include "core/base/number_text.h"
#include "core/base/random_source.h"
#include "core/connection/circle_text.h"
#include "core/session/entry.h"
#include "core/session/row_fields.h"
#include "core/session/row_order.h"

namespace alidade {

std::vector<SimulatedSighting> sightingsOf(const Session& session, Angle noise, std::uint64_t seed) {
  const auto read = verticalCircleEntry(session.geometry.verticalCircle);
  const VerticalCircle circle = read ? *read : VerticalCircle::Zenith;
  RandomSource random(seed);
  std::vector<SimulatedSighting> sightings;
  const auto add = [&](const std::string& horizontal, const std::string& vertical,
                       const std::string& cross = {}, const std::string& length = {}) {
    const auto alpha = angleEntry(horizontalRule, horizontal, circle);
    const auto beta = angleEntry(verticalRule, vertical, circle);
    if (!alpha || !*alpha || !beta || !*beta) return;
    const auto drawn = [&](Angle angle) {
      const Angle off = noise > Angle() ? noise * random.normal() : Angle();
      return wrapped(angle + off, Angle::fromDegrees(180));
    };
    const auto tilt = [](const std::string& text) {
      const Result<double> arcseconds = parseNumber(text);
      return arcseconds ? Angle::fromArcseconds(*arcseconds) : Angle();
    };
    sightings.push_back({drawn(**alpha), drawn(zenithOf(**beta, circle)), tilt(cross), tilt(length)});
  };
  for (const std::size_t index : positionsAsTaken(session)) {
    const Position& position = session.positions[index];
    const auto addZeros = [&](bool isAfter) {
      for (const ZeroSlot& slot : furtherZeros)
        if (slot.isAfter == isAfter)
          add((position.zero.*slot.sighting).horizontal, (position.zero.*slot.sighting).vertical);
    };
    add(position.zero.horizontal, position.zero.vertical);
    addZeros(false);
    for (const Reading& row : position.readings)
      add(row.horizontal, row.vertical, row.tiltCrossArcsec, row.tiltLengthArcsec);
    addZeros(true);
  }
  return sightings;
}

}  // namespace alidade
