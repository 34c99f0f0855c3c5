#include <nlohmann/json.hpp>
#include <utility>

#include "core/session/json_layout.h"
#include "core/session/json_object_writer.h"
#include "core/session/known_size_json.h"
#include "core/session/row_fields.h"
#include "core/session/session_file.h"
#include "core/session/value_text.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

Json reportJson(const ReportEntries& report) {
  ObjectWriter writer(report.origin);
  writer.text("number", report.number);
  writer.text("laboratory", report.laboratory);
  writer.text("customer", report.customer);
  writer.text("authorised_by", report.authorisedBy);
  writer.text("rule_agreed_by", report.ruleAgreedBy);
  return writer.take();
}

Json deviceJson(const Device& device) {
  ObjectWriter writer(device.origin);
  writer.text("name", device.name);
  writer.text("serial", device.serial);
  writer.part("known", knownJson(device.known));
  return writer.take();
}

Json namedRecordJson(const NamedRecord& record) {
  ObjectWriter writer(record.origin);
  writer.text("file", record.file);
  writer.text("date", record.date);
  return writer.take();
}

Json instrumentJson(const Instrument& instrument) {
  ObjectWriter writer(instrument.origin);
  writer.text("name", instrument.name);
  writer.text("serial", instrument.serial);
  writer.text("certificate", instrument.certificate);
  writer.text("traceability", instrument.traceability);
  writer.text("angle_unit", instrument.angleUnit);
  writer.number("sigma_horizontal_arcsec", instrument.sigmaHorizontalArcsec);
  writer.number("sigma_vertical_arcsec", instrument.sigmaVerticalArcsec);
  writer.number("sigma_zero_arcsec", instrument.sigmaZeroArcsec);
  writer.number("sigma_slider_arcsec", instrument.sigmaSliderArcsec);
  writer.number("sigma_compensator_arcsec", instrument.sigmaCompensatorArcsec);
  writeLineOfSight(writer, instrument.lineOfSight);
  writer.part("record", namedRecordJson(instrument.record));
  writer.part("known", knownJson(instrument.known));
  return writer.take();
}

Json environmentJson(const Environment& environment) {
  ObjectWriter writer(environment.origin);
  writer.number("temperature_c", environment.temperatureC);
  writer.number("sigma_temperature_c", environment.sigmaTemperatureC);
  return writer.take();
}

Json geometryJson(const Geometry& geometry) {
  ObjectWriter writer(geometry.origin);
  writer.number("distance_mm", geometry.distanceMm, Presence::Required);
  writer.number("sigma_distance_mm", geometry.sigmaDistanceMm);
  writer.number("radius_mm", geometry.radiusMm, Presence::Required);
  writer.number("sigma_radius_mm", geometry.sigmaRadiusMm);
  writer.text("vertical_circle", geometry.verticalCircle);
  writer.text("pointing_zeros", geometry.pointingZeros);
  writer.text("plane", geometry.plane);
  writer.text("zero_is", geometry.zeroIs);
  writer.text("distance_from", geometry.distanceFrom);
  writer.number("distance_expansion_ppm_per_k", geometry.distanceExpansionPpmPerK);
  writer.number("radius_expansion_ppm_per_k", geometry.radiusExpansionPpmPerK);
  return writer.take();
}

Json acceptanceJson(const Acceptance& acceptance) {
  ObjectWriter writer(acceptance.origin);
  writer.number("tolerance_mm", acceptance.toleranceMm);
  writer.text("measurand", acceptance.measurand);
  writer.number("coverage", acceptance.coverage);
  writer.number("reference_intersection_mm", acceptance.referenceIntersectionMm);
  writer.number("sigma_reference_mm", acceptance.sigmaReferenceMm);
  return writer.take();
}

Json modelJson(const Model& model) {
  ObjectWriter writer(model.origin);
  writer.text("vertical_angle", model.verticalAngle);
  writer.text("radius", model.radius);
  writer.list("effects", model.effects);
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
  writer.text("title", session.title);
  writer.text("notes", session.notes);
  writer.text("operator", session.operatorName);
  writer.text("place", session.place);
  writer.text("measured_on", session.measuredOn);
  writer.part("report", reportJson(session.report));
  writer.part("device", deviceJson(session.device));
  writer.part("instrument", instrumentJson(session.instrument));
  writer.part("environment", environmentJson(session.environment));
  writer.part("geometry", geometryJson(session.geometry), Presence::Required);
  writer.part("acceptance", acceptanceJson(session.acceptance));
  writer.part("model", modelJson(session.model));
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
