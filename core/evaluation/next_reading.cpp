#include "core/evaluation/next_reading.h"

#include <algorithm>
#include <utility>

#include "core/session/entry_to_come.h"
#include "core/session/row_fields.h"
#include "core/session/sighting_order.h"

namespace alidade {

namespace {

constexpr std::size_t mostTyped = 10'000;

bool isOpen(const Reading& row) {
  return !row.excluded && (row.horizontal.empty() || row.vertical.empty());
}

std::optional<NextReading> nextOf(const Session& session, std::size_t position, const Guide* guide) {
  const std::vector<Reading>& rows = session.positions[position].readings;
  const auto open = std::ranges::find_if(rows, isOpen);
  const bool isInTable = open != rows.end();
  const bool isLed = guide && guide->problem.empty();
  if (!isInTable && isLed && !nextPlaceIn(guide->progress, position)) return {};
  const auto chosen = isLed && guide->choice ? std::optional(guide->choice->next) : std::nullopt;
  if (!isInTable && !isLed && hasAllOfAnother(session, position)) return {};
  return NextReading{static_cast<std::size_t>(open - rows.begin()),
                     isInTable ? *open : followingReading(session, position, chosen)};
}

std::optional<SightingToCome> sightingOf(const NextReading& next, std::size_t position) {
  const auto point = wholeEntry(pointRule, next.sighting.point);
  const auto round = wholeEntry(roundRule, next.sighting.round);
  const auto face = wholeEntry(faceRule, next.sighting.face);
  if (!point || !*point || !round || !face) return {};
  return SightingToCome{position, **point, **round, **face};
}

/// The expected reading of a sighting, from the protocol.
std::optional<ExpectedReading> ledTo(const Guide& guide, const SightingToCome& sighting) {
  for (std::size_t i = 0; i < guide.progress.sightings.size(); ++i) {
    const FollowedSighting& followed = guide.progress.sightings[i];
    const PlannedSighting& planned = followed.planned;
    if (followed.position == sighting.position && !planned.isZero && planned.point == sighting.point &&
        planned.round == sighting.round && planned.face == sighting.face)
      return guide.expected[i];
  }
  return {};
}

}  // namespace

std::vector<std::optional<NextReading>> nextReadings(const Session& session, const Measurement* measurement,
                                                     const SessionFit& fit, const Guide* guide) {
  std::vector<std::optional<NextReading>> next;
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  if (rows > mostTyped) return next;
  std::vector<SightingToCome> sightings;
  for (std::size_t i = 0; i < session.positions.size(); ++i) {
    next.push_back(nextOf(session, i, guide));
    if (!next.back()) continue;
    if (const auto sighting = sightingOf(*next.back(), i)) sightings.push_back(*sighting);
  }
  if (!measurement) return next;
  const auto expected = expectedReadings(*measurement, fit, sightings);
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const auto led = guide ? ledTo(*guide, sightings[i]) : std::nullopt;
    next[sightings[i].position]->expected = led ? led : expected[i];
  }
  return next;
}

}  // namespace alidade
