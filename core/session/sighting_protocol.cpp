#include "core/session/sighting_protocol.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "core/base/file_bytes.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "core/session/json_object_reader.h"
#include "core/session/json_object_writer.h"
#include "core/session/json_text.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

constexpr JsonFormat protocolFormat = {
    "alidade-protocol",
    PHRASE_LATER("Phrase",
                 "is missing, so this is no measurement protocol: choose a file with \"format\": "
                 "\"alidade-protocol\""),
    PHRASE_LATER("Phrase", "choose a measurement protocol"),
    PHRASE_LATER("Phrase", "%1 is no version of a measurement protocol: it must be %2")};

constexpr const char *orderListed = "listed", *orderByWorth = "by_worth";

constexpr AngleRule turnRule{
    .low = -360, .lowOfElevation = -360, .high = 360, .isHighIncluded = true, .mayBeEmpty = true};

constexpr NumberRule minutesRule{
    .low = 0,
    .lowBound = Bound::Included,
    .high = 1000,
    .fallback = {},
    .refusal = PHRASE_LATER(
        "Phrase",
        "%1 min is out of range: turning the axis, plunging or driving the slider takes 0 to 1000 min")};

constexpr std::pair<const char*, double SightingMinutes::*> partsOfMinutes[] = {
    {"turning_axis", &SightingMinutes::turningAxis},
    {"plunging_telescope", &SightingMinutes::plungingTelescope},
    {"driving_slider", &SightingMinutes::drivingSlider}};

/// Reads a protocol from JSON; keeps the first problem.
class ProtocolReader {
 public:
  using Json = nlohmann::ordered_json;

  ProtocolReader(const ObjectReader& reader, std::optional<Problem>& problem)
      : m_reader(reader), m_problem(problem) {}

  SightingProtocol read() {
    SightingProtocol protocol;
    protocol.name = m_reader.text("name");
    protocol.description = m_reader.text("description");
    protocol.readsSlider = m_reader.flag("read_slider");
    protocol.isByWorth = isByWorth();
    protocol.isYielding = m_reader.flag("yields");
    protocol.minutes = minutes(m_reader.object("minutes"));
    protocol.places = places(m_reader);
    m_reader.require("positions",
                     PHRASE_LATER("Phrase", "add the list of the positions of the axis, in their order"));
    for (const Json& position : m_reader.list("positions")) {
      if (m_problem) break;
      protocol.positions.push_back(
          this->position(m_reader.member("positions", protocol.positions.size(), position), protocol));
    }
    if (protocol.positions.empty())
      m_reader.report(Phrase::of("is empty: add the positions of the axis, in their order"),
                      m_reader.placeOf("positions"));
    protocol.origin = m_reader.origin({"minutes", "places", "positions"});
    if (const std::size_t count = sightingCount(protocol); count > mostSightings)
      m_reader.report(
          Phrase::of("make %1 sightings, and a protocol holds at most %2: leave out rounds or places", count,
                     mostSightings),
          m_reader.placeOf("positions"));
    return protocol;
  }

 private:
  bool isByWorth() const {
    const std::string order = m_reader.text("order");
    if (!order.empty() && order != orderListed && order != orderByWorth)
      m_reader.report(Phrase::of("%1 is no order of sightings: write %2 or %3", quotation(order), orderListed,
                                 orderByWorth),
                      m_reader.placeOf("order"));
    return order == orderByWorth;
  }

  SightingMinutes minutes(const ObjectReader& reader) {
    SightingMinutes minutes;
    for (const auto& [key, part] : partsOfMinutes) {
      const auto entry = numberEntry(minutesRule, reader.number(key));
      if (!entry)
        reader.report(entry.problem().what, reader.placeOf(key));
      else if (*entry)
        minutes.*part = **entry;
    }
    minutes.origin = reader.origin();
    return minutes;
  }

  std::vector<ProtocolPlace> places(const ObjectReader& reader) {
    std::vector<ProtocolPlace> places;
    std::set<int> points;
    for (const Json& json : reader.list("places")) {
      if (m_problem) break;
      const ObjectReader own = reader.member("places", places.size(), json);
      ProtocolPlace place;
      const std::string point = own.number("point");
      place.point = point.empty() ? static_cast<int>(places.size()) + 1 : whole(own, "point", pointRule);
      if (!points.insert(place.point).second)
        own.report(Phrase::of("%1 occurs twice: each place needs a number of its own", place.point),
                   own.placeOf("point"));
      place.slider = angle(own, "slider", sliderRule);
      place.arc = angle(own, "arc", sliderRule);
      place.origin = own.origin();
      places.push_back(std::move(place));
    }
    return places;
  }

  ProtocolPosition position(const ObjectReader& reader, const SightingProtocol& protocol) {
    ProtocolPosition position;
    const auto axis = axisEntry(reader.requiredNumber(
        "axis_deg", PHRASE_LATER("Phrase", "say which position of the axis: 0 or 180")));
    if (axis)
      position.axisDeg = *axis;
    else
      reader.report(axis.problem().what, reader.placeOf("axis_deg"));
    position.circleTurn = angle(reader, "circle_turn", turnRule);
    position.zeros = zeros(reader.object("zeros"));
    position.places = places(reader);
    if (protocol.placesOf(position).empty())
      reader.report(Phrase::of("are missing: add the places of the slider, at least one"),
                    reader.placeOf("places"));
    position.rounds.clear();
    for (const Json& round : reader.list("rounds")) {
      if (m_problem) break;
      position.rounds.push_back(this->round(reader.member("rounds", position.rounds.size(), round)));
    }
    if (!reader.find("rounds")) {
      position.rounds = {{}};
    } else if (position.rounds.empty()) {
      reader.report(Phrase::of("is empty: add the rounds, at least one"), reader.placeOf("rounds"));
    }
    position.origin = reader.origin({"zeros", "places", "rounds"});
    return position;
  }

  ProtocolZeros zeros(const ObjectReader& reader) {
    ProtocolZeros zeros;
    const auto once = [&](const char* key, std::vector<int> fallback) {
      std::vector<int> faces = this->faces(reader, key, std::move(fallback));
      if (faces.size() > 2 || (faces.size() == 2 && faces[0] == faces[1]))
        reader.report(Phrase::of("names a face twice: a pointing zero is sighted once in each face"),
                      reader.placeOf(key));
      return faces;
    };
    zeros.before = once("before", {1});
    zeros.after = once("after", {});
    if (std::ranges::find(zeros.before, 1) == zeros.before.end())
      reader.report(Phrase::of("lacks face 1: before the readings the pointing zero is sighted in face 1, "
                               "and optionally in face 2"),
                    reader.placeOf("before"));
    zeros.origin = reader.origin();
    return zeros;
  }

  ProtocolRound round(const ObjectReader& reader) {
    ProtocolRound round;
    const std::string way = reader.text("way");
    if (!way.empty() && way != "there" && way != "back")
      reader.report(
          Phrase::of("%1 is no direction through the places: write \"there\" or \"back\"", quotation(way)),
          reader.placeOf("way"));
    round.isBack = way == "back";
    round.faces = faces(reader, "faces", {1});
    const auto isPair = [&](std::size_t first) { return round.faces[first] != round.faces[first + 1]; };
    const std::size_t count = round.faces.size();
    const bool isSound = count == 1 || (count == 2 && isPair(0)) || (count == 4 && isPair(0) && isPair(2));
    if (!isSound)
      reader.report(Phrase::of("must be one face, both, or both for each of two places: [1], [1, 2], [2, 1], "
                               "[1, 2, 2, 1]"),
                    reader.placeOf("faces"));
    round.origin = reader.origin();
    return round;
  }

  std::vector<int> faces(const ObjectReader& reader, const char* key, std::vector<int> fallback) {
    if (!reader.find(key)) return fallback;
    std::vector<int> faces;
    for (const Json& json : reader.list(key)) {
      const bool isFace = json.is_number_integer() && (json == 1 || json == 2);
      if (!isFace) {
        reader.report(Phrase::of("contains something other than a face: write 1 or 2, as in [1, 2]"),
                      reader.placeOf(key));
        return {1};
      }
      faces.push_back(json.get<int>());
    }
    return faces;
  }

  int whole(const ObjectReader& reader, const char* key, const WholeRule& rule) {
    const auto entry = wholeEntry(rule, reader.number(key));
    if (entry && *entry) return **entry;
    if (!entry) reader.report(entry.problem().what, reader.placeOf(key));
    return 0;
  }

  std::string angle(const ObjectReader& reader, const char* key, const AngleRule& rule) {
    std::string text = reader.angle(key);
    const auto entry = angleEntry(rule, text, VerticalCircle::Zenith);
    if (!entry) reader.report(entry.problem().what, reader.placeOf(key));
    return text;
  }

  const ObjectReader& m_reader;
  std::optional<Problem>& m_problem;
};

/// The JSON of minutes that differ from the usual ones, with unknown keys of the file.
nlohmann::ordered_json minutesJson(const SightingMinutes& minutes) {
  const SightingMinutes usual;
  ObjectWriter writer(minutes.origin);
  for (const auto& [key, part] : partsOfMinutes)
    writer.number(key, minutes.*part == usual.*part ? "" : shortestText(minutes.*part));
  return writer.take();
}

nlohmann::ordered_json placesJson(const std::vector<ProtocolPlace>& places) {
  auto list = nlohmann::ordered_json::array();
  for (const ProtocolPlace& place : places) {
    ObjectWriter writer(place.origin);
    writer.part("point", place.point, Presence::Required);
    writer.angle("slider", place.slider);
    writer.angle("arc", place.arc);
    list.push_back(writer.take());
  }
  return list;
}

nlohmann::ordered_json roundsJson(const std::vector<ProtocolRound>& rounds) {
  auto list = nlohmann::ordered_json::array();
  for (const ProtocolRound& round : rounds) {
    ObjectWriter writer(round.origin);
    writer.part("way", round.isBack ? "back" : "there", Presence::Required);
    writer.part("faces", round.faces, Presence::Required);
    list.push_back(writer.take());
  }
  return list;
}

nlohmann::ordered_json positionsJson(const std::vector<ProtocolPosition>& positions) {
  auto list = nlohmann::ordered_json::array();
  for (const ProtocolPosition& position : positions) {
    ObjectWriter writer(position.origin);
    writer.part("axis_deg", position.axisDeg, Presence::Required);
    writer.angle("circle_turn", position.circleTurn);
    ObjectWriter zeros(position.zeros.origin);
    zeros.part("before", position.zeros.before, Presence::Required);
    zeros.part("after", position.zeros.after);
    writer.part("zeros", zeros.take());
    writer.partIfAny("places", placesJson(position.places));
    writer.part("rounds", roundsJson(position.rounds));
    list.push_back(writer.take());
  }
  return list;
}

void write(ObjectWriter& writer, const SightingProtocol& protocol) {
  writer.text("name", protocol.name);
  writer.text("description", protocol.description);
  writer.flag("read_slider", protocol.readsSlider);
  writer.text("order", protocol.isByWorth ? orderByWorth : "");
  writer.flag("yields", protocol.isYielding);
  writer.part("minutes", minutesJson(protocol.minutes));
  writer.partIfAny("places", placesJson(protocol.places));
  writer.part("positions", positionsJson(protocol.positions), Presence::Required);
}

std::optional<Angle> angleOf(const std::string& text) {
  const auto entry = angleEntry(sliderRule, text, VerticalCircle::Zenith);
  return entry ? *entry : std::nullopt;
}

/// The problem, with its place inside the session's `protocol`.
Problem within(const Problem& problem) {
  const std::string inside = problem.where.path();
  return {problem.what, {.field = inside.empty() ? "protocol" : "protocol." + inside}};
}

}  // namespace

std::size_t sightingCount(const SightingProtocol& protocol) {
  std::size_t count = 0;
  for (const ProtocolPosition& position : protocol.positions) {
    count += position.zeros.before.size() + position.zeros.after.size();
    // With four faces, places alternate between 1 2 and 2 1, so each place has two.
    for (const ProtocolRound& round : position.rounds)
      count += protocol.placesOf(position).size() * std::min<std::size_t>(2, round.faces.size());
  }
  return count;
}

SightingProtocol openOrder(SightingProtocol protocol) {
  if (protocol.isByWorth) return protocol;
  protocol.isByWorth = true;
  const std::vector<ProtocolPosition> once = protocol.positions;
  protocol.positions.insert(protocol.positions.end(), once.begin(), once.end());
  if (sightingCount(protocol) > mostSightings) protocol.positions = once;
  return protocol;
}

SightingProtocol listedOrder(SightingProtocol protocol) {
  if (!protocol.isByWorth) return protocol;
  protocol.isByWorth = false;
  const auto half = protocol.positions.begin() + std::ssize(protocol.positions) / 2;
  if (std::equal(protocol.positions.begin(), half, half, protocol.positions.end()))
    protocol.positions.erase(half, protocol.positions.end());
  return protocol;
}

Result<SightingProtocol> readProtocol(std::string_view text) {
  nlohmann::ordered_json json;
  if (auto problem = parseJson(text, json)) return *std::move(problem);
  std::optional<Problem> problem;
  const ObjectReader reader(json, {}, problem);
  reader.checkFormat(protocolFormat);
  if (problem) return *problem;
  SightingProtocol protocol = ProtocolReader(reader, problem).read();
  if (problem) return *problem;
  return protocol;
}

std::string writeProtocol(const SightingProtocol& protocol) {
  ObjectWriter writer(protocol.origin);
  writer.constant("format", protocolFormat.id);
  writer.constant("version", 1);
  write(writer, protocol);
  return layoutJson(writer.take());
}

Result<SightingProtocol> loadProtocol(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.problem();
  return readProtocol(*bytes);
}

Result<std::optional<SightingProtocol>> statedProtocol(const Session& session) {
  if (session.protocol.empty()) return std::optional<SightingProtocol>();
  nlohmann::ordered_json json;
  if (const auto problem = parseJson(session.protocol, json)) return within(*problem);
  std::optional<Problem> problem;
  const ObjectReader reader(json, {}, problem);
  std::optional<SightingProtocol> protocol;
  if (!problem) protocol = ProtocolReader(reader, problem).read();
  if (problem) return within(*problem);
  return protocol;
}

std::string protocolText(const SightingProtocol& protocol) {
  ObjectWriter writer(protocol.origin);
  write(writer, protocol);
  nlohmann::ordered_json json = writer.take();
  json.erase("format");
  json.erase("version");
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::optional<Angle> nominalPlace(const ProtocolPlace& place) {
  return angleOf(place.arc.empty() ? place.slider : place.arc);
}

Angle circleTurn(const ProtocolPosition& position) {
  return angleOf(position.circleTurn).value_or(Angle());
}

}  // namespace alidade
