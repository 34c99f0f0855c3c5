#include "core/session/session_reader.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/phrase.h"
#include "core/session/json_object_reader.h"
#include "core/session/known_size_json.h"
#include "core/session/row_fields.h"
#include "core/session/session_fields.h"
#include "core/session/value_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t largestExactInteger = std::uint64_t{1} << 53;

/// Does the row's text represent the value completely, so that it is written as read?
bool isKeptAsText(std::string_view key, const Json& value) {
  const RowField* field = rowFieldNamed(key);
  if (!field || !field->text) return false;
  if (kindOf(*field) != ValueKind::Number)
    return value.is_string() && (field->remedy || !value.get_ref<const std::string&>().empty());
  return value.is_number_unsigned() && value.get<std::uint64_t>() <= largestExactInteger;
}

constexpr JsonFormat sessionFormat = {
    "alidade-session",
    PHRASE_LATER(
        "Phrase",
        "is missing, so this is no session file: choose a file with \"format\": \"alidade-session\""),
    PHRASE_LATER("Phrase", "choose a session file"),
    PHRASE_LATER("Phrase", "%1 is no version of a session file: it must be %2")};

/// Reads the fields of one object of the file.
void readFields(const ObjectReader& reader, std::string_view part, Session& session) {
  for (const SessionField& field : sessionFields())
    if (field.part() == part && (!field.remedy || reader.require(field.name(), field.remedy)))
      field.at(session) = reader.value(field.name(), field.kind());
}

/// Reads an object with single texts, and its origin without the values of `others`.
ObjectReader readPart(const ObjectReader& document, const char* part, Session& session, JsonOrigin& origin,
                      const std::vector<const char*>& others = {}) {
  ObjectReader reader = document.object(part);
  readFields(reader, part, session);
  origin = reader.origin(others);
  return reader;
}

NamedRecord readNamedRecord(const ObjectReader& reader) {
  return {.file = reader.text("file"), .date = reader.text("date"), .origin = reader.origin()};
}

PointingZero readPointingZero(const ObjectReader& reader) {
  constexpr const char* remedy =
      PHRASE_LATER("Phrase", "add the reading of the direction perpendicular to the arc plane");
  PointingZero zero;
  zero.horizontal = reader.requiredAngle("horizontal", remedy);
  zero.vertical = reader.requiredAngle("vertical", remedy);
  zero.takenAt = reader.text("taken_at");
  zero.returnCode = reader.number("return_code");
  zero.instrumentSerial = reader.text("instrument_serial");
  std::vector<const char*> parts;
  for (const ZeroSlot& slot : furtherZeros) {
    const ObjectReader own = reader.object(slot.key);
    zero.*slot.sighting = {own.angle("horizontal"), own.angle("vertical"),     own.origin(),
                           own.text("taken_at"),    own.number("return_code"), own.text("instrument_serial")};
    parts.push_back(slot.key);
  }
  zero.origin = reader.origin(parts);
  return zero;
}

void readFirstTexts(const ObjectReader& reader, Reading& row) {
  for (const RowField& field : rowFields)
    if (field.text && reader.find(field.key))
      row.asRead.set(field.key, reader.value(field.key, kindOf(field)));
}

JournalEntry readJournalEntry(const ObjectReader& reader) {
  JournalEntry entry;
  for (const JournalField& field : journalFields) entry.*field.text = reader.text(field.key);
  entry.origin = reader.origin();
  return entry;
}

void readRow(const ObjectReader& reader, Reading& row) {
  for (const RowField& field : rowFields) {
    if (field.flag)
      row.*field.flag = reader.flag(field.key);
    else if (!field.remedy || reader.require(field.key, field.remedy))
      row.*field.text = reader.value(field.key, kindOf(field));
  }
  if (reader.find("as_read")) readFirstTexts(reader.object("as_read"), row);
}

Position readPosition(const Json& json, std::size_t index, RowsRead rows, std::optional<Problem>& problem) {
  const ObjectReader reader(json, {.position = index}, problem);
  Position position;
  position.axisDeg =
      reader.requiredNumber("axis_deg", PHRASE_LATER("Phrase", "add the rotation of the axis, 0 or 180"));
  reader.require(
      "pointing_zero",
      PHRASE_LATER("Phrase", "add the circle readings of the direction perpendicular to the arc plane"));
  if (problem) return position;
  position.zero = readPointingZero(reader.object("pointing_zero"));
  reader.list("readings");  // reports any value that is not a list
  if (!problem) problem = std::move(rows.problem);
  position.readings = std::move(rows.readings);
  position.origin = reader.origin({"pointing_zero", "readings"});
  return position;
}

Session readDocument(const ObjectReader& reader, SessionRows& rows, std::optional<Problem>& problem) {
  Session session;
  readFields(reader, "", session);
  readPart(reader, "report", session, session.report.origin);
  const ObjectReader device = readPart(reader, "device", session, session.device.origin, {"known"});
  session.device.known = readKnown(device);
  const ObjectReader instrument =
      readPart(reader, "instrument", session, session.instrument.origin, {"record", "known"});
  session.instrument.record = readNamedRecord(instrument.object("record"));
  session.instrument.known = readKnown(instrument);
  readPart(reader, "environment", session, session.environment.origin);
  if (reader.require("geometry", PHRASE_LATER("Phrase", "add the distance and the nominal radius")))
    readPart(reader, "geometry", session, session.geometry.origin);
  readPart(reader, "acceptance", session, session.acceptance.origin);
  session.model.effects = entriesOf(readPart(reader, "model", session, session.model.origin).list("effects"));
  session.ownEffects = readOwnEffects(reader);
  reader.require("positions",
                 PHRASE_LATER("Phrase", "add the list of the positions of the axis, which may be empty"));
  for (const Json& position : reader.list("positions")) {
    if (problem) break;
    const std::size_t index = session.positions.size();
    session.positions.push_back(readPosition(position, index, rows.take(index), problem));
  }
  if (const Json* protocol = reader.find("protocol"))
    session.protocol = protocol->dump(-1, ' ', false, Json::error_handler_t::replace);
  for (const Json& entry : reader.list("journal"))
    session.journal.push_back(readJournalEntry(reader.member("journal", session.journal.size(), entry)));
  session.origin = reader.origin({"report", "device", "instrument", "environment", "geometry", "acceptance",
                                  "model", "own_effects", "positions", "protocol", "journal"});
  return session;
}

/// Are both written identically? 1 differs from 1.0.
bool isSame(const Json& a, const Json& b) {
  if (a.type() != b.type()) return false;
  return a.is_structured() || a.is_number_float() ? a.dump() == b.dump() : a == b;
}

/// The row with null for its text values, which the writer inserts. The remainder is equal in most rows.
Json withoutTexts(Json row) {
  for (auto& [key, value] : row.get_ref<Json::object_t&>())
    if (isKeptAsText(key, value)) value = nullptr;
  return row;
}

}  // namespace

bool SessionRows::isLikeLast(const Json& row) const {
  return std::ranges::equal(
      row.get_ref<const Json::object_t&>(), m_last.object().get_ref<const Json::object_t&>(),
      [](const auto& own, const auto& last) {
        return own.first == last.first && (isSame(own.second, last.second) ||
                                           (last.second.is_null() && isKeptAsText(own.first, own.second)));
      });
}

void SessionRows::add(const Place& where, const Json& row) {
  if (m_positions.size() <= *where.position) m_positions.resize(*where.position + 1);
  RowsRead& rows = m_positions[*where.position];
  if (rows.problem) return;
  readRow(ObjectReader(row, where, rows.problem), rows.readings.emplace_back());
  if (rows.problem) return;
  if (!isLikeLast(row)) m_last = JsonOrigin(withoutTexts(row));
  rows.readings.back().origin = m_last;
}

RowsRead SessionRows::take(std::size_t position) {
  return position < m_positions.size() ? std::move(m_positions[position]) : RowsRead();
}

Result<Session> sessionFromJson(const Json& document, SessionRows rows) {
  std::optional<Problem> problem;
  if (!document.is_object()) {
    return Problem{
        Phrase::of("is %1, not an object in braces: this is no session file", jsonTypeName(document))};
  }
  const ObjectReader reader(document, {}, problem);
  reader.checkFormat(sessionFormat);
  if (problem) return *problem;
  Session session = readDocument(reader, rows, problem);
  if (problem) return *problem;
  return session;
}

}  // namespace alidade
