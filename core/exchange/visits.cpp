#include "core/exchange/visits.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "core/base/phrase.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

/// An entry normalised as a number, so that 1 and 01 are one point.
std::string asNumber(const WholeRule& rule, const std::string& text) {
  const auto number = wholeEntry(rule, text);
  return number && *number ? std::to_string(**number) : text;
}

/// Point, face and round.
using Visited = std::tuple<std::string, std::string, std::string>;

Visited visited(const Reading& row) {
  return {asNumber(pointRule, row.point), asNumber(faceRule, row.face), asNumber(roundRule, row.round)};
}

std::string axisOf(const Position& position) {
  const Result<int> axis = axisEntry(position.axisDeg);
  return axis ? std::to_string(*axis) : position.axisDeg;
}

/// The sightings at an axis so far.
struct AtAxis {
  int repeat = 0;             ///< repeat of the current position; 0: there is none yet
  std::set<Visited> sighted;  ///< visits in the current position
};

/// Consecutive readings at the same axis angle.
struct Turn {
  std::string axis;
  std::vector<RecordedSighting*> sightings;
};

std::vector<Turn> turnsOf(std::vector<RecordedSighting>& sightings) {
  std::vector<Turn> turns;
  for (RecordedSighting& sighting : sightings) {
    if (turns.empty() || turns.back().axis != sighting.axis.text) turns.push_back({sighting.axis.text, {}});
    turns.back().sightings.push_back(&sighting);
  }
  return turns;
}

/// The last position of `base` at each axis and its sightings; `last` becomes the last axis with rows.
std::map<std::string, AtAxis> lastPositions(const Session& base, std::string& last) {
  std::map<std::string, AtAxis> axes;
  std::map<std::string, int> count;
  bool hasRows = false;
  for (const Position& position : base.positions) hasRows = hasRows || !position.readings.empty();
  if (!hasRows) return axes;
  for (const Position& position : base.positions) {
    const std::string axis = axisOf(position);
    AtAxis& at = axes[axis];
    at = {.repeat = ++count[axis], .sighted = {}};
    for (const Reading& row : position.readings)
      if (!row.point.empty()) at.sighted.insert(visited(row));
    if (!position.readings.empty()) last = axis;
  }
  return axes;
}

/// The visits of a turn, without pointing zeros.
std::set<Visited> placesOf(const Turn& turn) {
  std::set<Visited> places;
  for (const RecordedSighting* sighting : turn.sightings)
    if (!sighting->isZero && !sighting->row.point.empty()) places.insert(visited(sighting->row));
  return places;
}

}  // namespace

PositionKey positionOf(const RecordedSighting& sighting) {
  return {sighting.axis.text, sighting.repeat};
}

std::string nameOf(const PositionKey& key) {
  return key.second > 1 ? Phrase::of("%1°, repeat %2", key.first, key.second) : key.first + "°";
}

const Position* positionIn(const Session& session, const PositionKey& key) {
  int repeat = 0;
  for (const Position& position : session.positions)
    if (axisOf(position) == key.first && ++repeat == key.second) return &position;
  return nullptr;
}

void takePositions(std::vector<RecordedSighting>& sightings, const Session& base) {
  std::string last;
  std::map<std::string, AtAxis> axes = lastPositions(base, last);
  for (Turn& turn : turnsOf(sightings)) {
    AtAxis& at = axes[turn.axis];
    std::set<Visited> places = placesOf(turn);
    const bool isAgain = turn.axis != last && std::ranges::any_of(places, [&at](const Visited& place) {
                           return at.sighted.contains(place);
                         });
    if (at.repeat == 0 || isAgain) {
      ++at.repeat;
      at.sighted.clear();
    }
    at.sighted.merge(places);
    for (RecordedSighting* sighting : turn.sightings) sighting->repeat = at.repeat;
    last = turn.axis;
  }
}

bool takeRounds(std::vector<RecordedSighting>& sightings, const Session& base) {
  using Target = std::tuple<PositionKey, std::string, std::string>;
  std::map<Target, std::set<std::string>> stated;
  std::set<PositionKey> keys;
  for (const RecordedSighting& sighting : sightings) keys.insert(positionOf(sighting));
  for (const PositionKey& key : keys)
    if (const Position* position = positionIn(base, key))
      for (const Reading& row : position->readings) {
        const auto [point, face, round] = visited(row);
        stated[{key, point, face}].insert(round);
      }
  const auto placeOf = [](const RecordedSighting& sighting) {
    const auto [point, face, round] = visited(sighting.row);
    return Target{positionOf(sighting), point, face};
  };
  for (const RecordedSighting& sighting : sightings)
    if (!sighting.isZero && !sighting.row.round.empty())
      stated[placeOf(sighting)].insert(asNumber(roundRule, sighting.row.round));
  std::map<Target, int> last;
  bool isFurther = false, isAnyStated = false;
  for (RecordedSighting& sighting : sightings) {
    if (sighting.isZero || !sighting.row.round.empty() || sighting.row.point.empty()) continue;
    const Target place = placeOf(sighting);
    int& round = last[place];
    do ++round;
    while (stated[place].contains(std::to_string(round)));
    isFurther = isFurther || round > 1;
    if (round > 1) sighting.row.round = std::to_string(round);
  }
  for (const RecordedSighting& sighting : sightings) isAnyStated = isAnyStated || !sighting.row.round.empty();
  for (RecordedSighting& sighting : sightings)
    if (isAnyStated && !sighting.isZero && sighting.row.round.empty()) sighting.row.round = "1";
  return isFurther;
}

}  // namespace alidade
