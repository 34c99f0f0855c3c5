#include <nlohmann/json.hpp>
#include <utility>

#include "core/session/json_object_writer.h"
#include "core/session/json_text.h"
#include "core/session/known_size_json.h"
#include "core/session/row_fields.h"
#include "core/session/session_fields.h"
#include "core/session/session_file.h"
#include "core/session/value_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

/// Writes the fields of one object of the file.
void writeFields(ObjectWriter& writer, std::string_view part, const Session& session) {
  for (const SessionField& field : sessionFields())
    if (field.part() == part)
      writer.set(field.name(), field.get(session), field.kind(),
                 field.remedy ? Presence::Required : Presence::Optional);
}

/// An object with single texts only.
Json partJson(std::string_view part, const JsonOrigin& origin, const Session& session) {
  ObjectWriter writer(origin);
  writeFields(writer, part, session);
  return writer.take();
}

Json deviceJson(const Session& session) {
  ObjectWriter writer(session.device.origin);
  writeFields(writer, "device", session);
  writer.part("known", knownJson(session.device.known));
  return writer.take();
}

Json namedRecordJson(const NamedRecord& record) {
  ObjectWriter writer(record.origin);
  writer.text("file", record.file);
  writer.text("date", record.date);
  return writer.take();
}

Json instrumentJson(const Session& session) {
  ObjectWriter writer(session.instrument.origin);
  writeFields(writer, "instrument", session);
  writer.part("record", namedRecordJson(session.instrument.record));
  writer.part("known", knownJson(session.instrument.known));
  return writer.take();
}

Json modelJson(const Session& session) {
  ObjectWriter writer(session.model.origin);
  writeFields(writer, "model", session);
  writer.list("effects", session.model.effects);
  return writer.take();
}

void writeArrival(ObjectWriter& writer, const ZeroSighting& sighting) {
  writer.text("taken_at", sighting.takenAt);
  writer.number("return_code", sighting.returnCode);
  writer.text("instrument_serial", sighting.instrumentSerial);
}

Json pointingZeroJson(const PointingZero& zero) {
  ObjectWriter writer(zero.origin);
  writer.angle("horizontal", zero.horizontal, Presence::Required);
  writer.angle("vertical", zero.vertical, Presence::Required);
  writeArrival(writer, firstSighting(zero));
  for (const ZeroSlot& slot : furtherZeros) {
    const ZeroSighting& sighting = zero.*slot.sighting;
    ObjectWriter own(sighting.origin);
    own.angle("horizontal", sighting.horizontal);
    own.angle("vertical", sighting.vertical);
    writeArrival(own, sighting);
    writer.part(slot.key, own.take());
  }
  return writer.take();
}

Json firstTextsJson(const FirstTexts& texts) {
  Json json = Json::object();
  for (const auto& [key, text] : texts.all()) {
    const RowField* field = rowFieldNamed(key);
    json[key] = valueOf(text, field ? kindOf(*field) : ValueKind::Text);
  }
  return json;
}

Json rowJson(const Reading& row) {
  ObjectWriter writer(row.origin);
  for (const RowField& field : rowFields) {
    if (field.flag)
      writer.flag(field.key, row.*field.flag);
    else
      writer.set(field.key, row.*field.text, kindOf(field),
                 field.remedy ? Presence::Required : Presence::Optional);
  }
  writer.partIfAny("as_read", firstTextsJson(row.asRead));
  return writer.take();
}

Json journalJson(const std::vector<JournalEntry>& journal) {
  Json entries = Json::array();
  for (const JournalEntry& entry : journal) {
    ObjectWriter writer(entry.origin);
    for (const JournalField& field : journalFields) writer.text(field.key, entry.*field.text);
    entries.push_back(writer.take());
  }
  return entries;
}

Json positionJson(const Position& position) {
  ObjectWriter writer(position.origin);
  writer.number("axis_deg", position.axisDeg, Presence::Required);
  writer.part("pointing_zero", pointingZeroJson(position.zero), Presence::Required);
  const bool isNew = position.origin.object().empty();
  writer.rows("readings", position.readings.size(), isNew ? Presence::Required : Presence::Optional);
  return writer.take();
}

/// The protocol's JSON as read; invalid JSON as a text.
Json protocolJson(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(text) : json;
}

}  // namespace

std::string writeSession(const Session& session) {
  ObjectWriter writer(session.origin);
  writer.constant("format", "alidade-session");
  writer.constant("version", 1);
  writeFields(writer, "", session);
  writer.part("report", partJson("report", session.report.origin, session));
  writer.part("device", deviceJson(session));
  writer.part("instrument", instrumentJson(session));
  writer.part("environment", partJson("environment", session.environment.origin, session));
  writer.part("geometry", partJson("geometry", session.geometry.origin, session), Presence::Required);
  writer.part("acceptance", partJson("acceptance", session.acceptance.origin, session));
  writer.part("model", modelJson(session));
  writer.partIfAny("own_effects", ownEffectsJson(session.ownEffects));
  Json positions = Json::array();
  for (const Position& position : session.positions) positions.push_back(positionJson(position));
  writer.part("positions", std::move(positions), Presence::Required);
  if (session.protocol.empty())
    writer.partIfAny("protocol", Json::object());
  else
    writer.part("protocol", protocolJson(session.protocol), Presence::Required);
  writer.partIfAny("journal", journalJson(session.journal));
  return layoutJson(writer.take(), [&](std::size_t position, std::size_t row) {
    return rowJson(session.positions[position].readings[row]);
  });
}

}  // namespace alidade
