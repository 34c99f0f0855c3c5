#include "core/guidance/advised_protocol.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/session/entry.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

/// A row with everything needed to sight it.
struct KeyedRow {
  int point = 0, round = 1, face = 1;
  std::string slider;
};

std::vector<KeyedRow> keyedRows(const Position& position) {
  std::vector<KeyedRow> rows;
  for (std::size_t i = 0; i < position.readings.size(); ++i) {
    const Reading& row = position.readings[i];
    const auto point = wholeEntry(pointRule, row.point);
    const auto round = wholeEntry(roundRule, row.round);
    const auto face = wholeEntry(faceRule, row.face);
    if (!point || !round || !face || row.excluded) continue;
    const auto slider = angleEntry(sliderRule, row.slider, VerticalCircle::Zenith);
    rows.push_back({point->value_or(static_cast<int>(i) + 1), round->value_or(1), face->value_or(1),
                    slider ? row.slider : std::string()});
  }
  return rows;
}

std::vector<ProtocolPlace> placesIn(const std::vector<KeyedRow>& rows) {
  std::vector<ProtocolPlace> places;
  std::map<int, std::size_t> indices;  // by point
  for (const KeyedRow& row : rows) {
    const auto [known, isNew] = indices.emplace(row.point, places.size());
    if (isNew)
      places.push_back({.point = row.point, .slider = row.slider});
    else if (places[known->second].slider.empty())
      places[known->second].slider = row.slider;
  }
  return places;
}

/// One protocol round for each round of the rows, in the faces of the first place of that round.
std::vector<ProtocolRound> roundsIn(const std::vector<KeyedRow>& rows,
                                    const std::vector<ProtocolPlace>& places) {
  std::map<int, std::vector<KeyedRow>> byRound;
  for (const KeyedRow& row : rows) byRound[row.round].push_back(row);
  std::vector<ProtocolRound> rounds;
  for (const auto& [number, own] : byRound) {
    ProtocolRound round;
    round.isBack = places.size() > 1 && own.front().point == places.back().point;
    round.faces.clear();
    for (const KeyedRow& row : own)
      if (row.point == own.front().point && std::ranges::find(round.faces, row.face) == round.faces.end())
        round.faces.push_back(row.face);
    rounds.push_back(std::move(round));
  }
  return rounds;
}

ProtocolZeros zerosIn(const PointingZero& zero) {
  ProtocolZeros zeros;
  for (const ZeroSlot& slot : furtherZeros)
    if (!(zero.*slot.sighting).horizontal.empty())
      (slot.isAfter ? zeros.after : zeros.before).push_back(slot.face);
  return zeros;
}

std::string degreesText(double degrees) {
  return shortestText(degrees) + "°";
}

void readInBothFaces(SightingProtocol& protocol) {
  for (ProtocolPosition& position : protocol.positions) {
    for (ProtocolRound& round : position.rounds)
      if (round.faces.size() == 1) round.faces.push_back(3 - round.faces.front());
    if (position.zeros.before.size() == 1) position.zeros.before.push_back(3 - position.zeros.before.front());
  }
}

void addWayBack(SightingProtocol& protocol) {
  for (ProtocolPosition& position : protocol.positions) {
    ProtocolRound back = position.rounds.back();
    back.isBack = !back.isBack;
    back.origin = {};
    position.rounds.push_back(std::move(back));
  }
}

/// Adds all positions again, with the circle turned by 60°.
void addShiftedCircle(SightingProtocol& protocol) {
  constexpr double shift = 60;
  const std::vector<ProtocolPosition> once = protocol.positions;
  for (ProtocolPosition position : once) {
    position.circleTurn = degreesText(std::round(circleTurn(position).degrees() * 3600) / 3600 + shift);
    protocol.positions.push_back(std::move(position));
  }
}

void addAgain(SightingProtocol& protocol, int axisDeg) {
  const auto found = std::ranges::find(protocol.positions, axisDeg, &ProtocolPosition::axisDeg);
  if (found == protocol.positions.end()) return;
  const ProtocolPosition again = *found;
  protocol.positions.push_back(again);
}

/// Adds places from 10° to 170° in steps of 10°, except within half a step of an existing place.
void addMoreOfTheArc(std::vector<ProtocolPlace>& places) {
  if (places.empty()) return;
  int point = 0;
  for (const ProtocolPlace& place : places) point = std::max(point, place.point);
  const std::vector<ProtocolPlace> before = places;
  for (int degrees = 10; degrees <= 170; degrees += 10) {
    const bool isThere = std::ranges::any_of(before, [&](const ProtocolPlace& place) {
      const auto own = nominalPlace(place);
      return own && std::abs(wrapped(*own - Angle::fromDegrees(degrees)).degrees()) < 5;
    });
    if (!isThere) places.push_back({.point = ++point, .slider = degreesText(degrees)});
  }
}

SightingProtocol unlessTooMuch(SightingProtocol protocol) {
  return sightingCount(protocol) > mostSightings ? SightingProtocol() : std::move(protocol);
}

}  // namespace

SightingProtocol protocolFromRows(const Session& session) {
  SightingProtocol protocol;
  std::optional<Angle> firstCircle;
  for (const Position& position : session.positions) {
    const auto axis = axisEntry(position.axisDeg);
    const std::vector<KeyedRow> rows = keyedRows(position);
    if (!axis) continue;
    ProtocolPosition own{.axisDeg = *axis, .zeros = zerosIn(position.zero), .rounds = {}};
    own.places = placesIn(rows);
    own.rounds = roundsIn(rows, own.places);
    const auto circle = angleEntry(horizontalRule, position.zero.horizontal, VerticalCircle::Zenith);
    if (circle && *circle) {
      if (!firstCircle) firstCircle = **circle;
      const double turn = std::round(wrapped(**circle - *firstCircle).degrees());
      if (turn != 0) own.circleTurn = degreesText(turn);
    }
    protocol.readsSlider = protocol.readsSlider ||
                           std::ranges::any_of(rows, [](const KeyedRow& row) { return !row.slider.empty(); });
    protocol.positions.push_back(std::move(own));
  }
  const auto like = std::ranges::find_if(
      protocol.positions, [](const ProtocolPosition& position) { return !position.places.empty(); });
  if (like == protocol.positions.end()) return {};
  protocol.places = like->places;
  const std::vector<ProtocolRound> rounds = like->rounds;
  const auto keysOf = [](const std::vector<ProtocolPlace>& places) {
    std::vector<int> points;
    for (const ProtocolPlace& place : places) points.push_back(place.point);
    return points;
  };
  for (ProtocolPosition& position : protocol.positions) {
    if (position.rounds.empty()) position.rounds = rounds;
    if (keysOf(position.places) == keysOf(protocol.places)) position.places.clear();
  }
  return unlessTooMuch(std::move(protocol));
}

bool isForProtocol(Measure measure) {
  return measure != Measure::SecondStandOff && measure != Measure::DistanceInBoth;
}

SightingProtocol withMeasures(SightingProtocol protocol, const std::vector<Measure>& measures) {
  for (const Measure measure : measures) {
    switch (measure) {
      case Measure::BothFaces:
        readInBothFaces(protocol);
        break;
      case Measure::WayBack:
        addWayBack(protocol);
        break;
      case Measure::SliderReadings:
        protocol.readsSlider = true;
        break;
      case Measure::ShiftedCircle:
        addShiftedCircle(protocol);
        break;
      case Measure::MoreOfTheArc:
        addMoreOfTheArc(protocol.places);
        for (ProtocolPosition& position : protocol.positions) addMoreOfTheArc(position.places);
        break;
      case Measure::ZeroSightedAgain:
        for (ProtocolPosition& position : protocol.positions) position.zeros.after = position.zeros.before;
        break;
      case Measure::At0Again:
        addAgain(protocol, 0);
        break;
      case Measure::At180Again:
        addAgain(protocol, 180);
        break;
      case Measure::SecondStandOff:
      case Measure::DistanceInBoth:
        break;
    }
  }
  return unlessTooMuch(std::move(protocol));
}

}  // namespace alidade
