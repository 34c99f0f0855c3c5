#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/session/row_fields.h"
#include "tests/support/hostile.h"

namespace alidade::test {

/// All hostile texts, concatenated.
inline std::string allHostileTexts() {
  std::string all;
  for (const HostileText& hostile : hostileTexts) all.append(hostile.text);
  return all;
}

/// The text of a session that can still be fitted, with `text` in every free entry: names, notes, an
/// uncatalogued effect, known sizes of unknown effects, unknown keys.
inline std::string hostileSession(const std::string& session, const std::string& text) {
  using Json = nlohmann::ordered_json;
  Json json = Json::parse(session);
  for (const char* key : {"title", "notes", "operator", "place"}) json[key] = text;
  for (const char* part : {"device", "instrument"})
    for (const char* key : {"name", "serial"}) json[part][key] = text;
  for (const char* key : {"number", "laboratory", "customer", "authorised_by", "rule_agreed_by"})
    json["report"][key] = text;
  for (const char* key : {"certificate", "traceability"}) json["instrument"][key] = text;
  json["geometry"]["distance_from"] = text;
  json["model"]["effects"] = {text};
  json["instrument"]["known"] = Json::array(
      {Json({{"effect", "collimation"}, {"sigma", 1}, {"unit", "arcsec"}, {"from", text}}),
       Json({{"effect", text}, {"parameter", text}, {"sigma", 1}, {"unit", text}, {"from", text}})});
  for (Json* object : {&json, &json["geometry"], &json["positions"][0]}) (*object)[text] = {{text, text}};
  for (Json& position : json["positions"])
    for (Json& row : position["readings"])
      for (const RowField& field : rowFields)
        if (isFreeText(field)) row[field.key] = text;
  return json.dump();
}

}  // namespace alidade::test
