#include "core/session/json_object_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"

namespace alidade {

namespace {

constexpr std::uint64_t newestVersion = 1;

/// Is this a whole number? 1.0 is a whole number, too: JSON has a single kind of number.
bool isWhole(const nlohmann::ordered_json& value) {
  return value.is_number_integer() ||
         (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
}

}  // namespace

std::string jsonTypeName(const nlohmann::ordered_json& value) {
  using Json = nlohmann::ordered_json;
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case Json::value_t::object:
      return Phrase::of("an object");
    case Json::value_t::array:
      return Phrase::of("a list");
    case Json::value_t::string:
      return Phrase::of("a text");
    default:
      return Phrase::of("a number");
  }
}

ObjectReader::ObjectReader(const Json& json, Place where, std::optional<Problem>& problem)
    : m_json(json), m_where(std::move(where)), m_problem(problem) {
  if (!json.is_object())
    report(Phrase::of("must be an object in braces, not %1", jsonTypeName(json)), m_where);
}

std::string ObjectReader::value(std::string_view key, ValueKind kind) const {
  const Json* found = find(key);
  if (!found) return {};
  auto text = textOf(*found, kind);
  //: two kinds of value: "a number", "a list"
  if (!text) report(Phrase::of("must be %1, not %2", wantedType(kind), jsonTypeName(*found)), placeOf(key));
  return text.value_or("");
}

bool ObjectReader::flag(std::string_view key) const {
  const Json* found = find(key);
  if (!found) return false;
  if (!found->is_boolean())
    report(Phrase::of("must be true or false, not %1", jsonTypeName(*found)), placeOf(key));
  return found->is_boolean() && found->get<bool>();
}

ObjectReader ObjectReader::object(const char* key) const {
  static const Json none = Json::object();
  const Json* found = find(key);
  return {found ? *found : none, placeOf(key), m_problem};
}

const ObjectReader::Json& ObjectReader::list(const char* key) const {
  static const Json none = Json::array();
  const Json* found = find(key);
  if (!found) return none;
  if (found->is_array()) return *found;
  report(Phrase::of("must be a list in square brackets, not %1", jsonTypeName(*found)), placeOf(key));
  return none;
}

ObjectReader ObjectReader::member(const char* key, std::size_t index, const Json& json) const {
  return {json, placeOf(std::string(key) + "[" + std::to_string(index) + "]"), m_problem};
}

bool ObjectReader::require(std::string_view key, const char* remedy) const {
  if (find(key)) return true;
  //: what to do about it: "add the rotation of the axis, 0 or 180"
  if (m_json.is_object()) report(Phrase::of("is missing: %1", Phrase::of(remedy)), placeOf(key));
  return false;
}

void ObjectReader::checkFormat(const JsonFormat& format) const {
  const Json* own = find("format");
  if (!own)
    report(Phrase::of(format.isNone), placeOf("format"));
  else if (own->is_string() && *own != format.id)
    //: what the file says, what it should say, and what to do: "choose a session file"
    report(Phrase::of("%1 is not \"%2\": %3", quotation(own->get_ref<const std::string&>()), format.id,
                      Phrase::of(format.choose)),
           placeOf("format"));
  else if (!own->is_string())
    report(Phrase::of("is not \"%1\": %2", format.id, Phrase::of(format.choose)), placeOf("format"));
  if (!require("version", PHRASE_LATER("Phrase", "add \"version\": 1"))) return;
  const Json& version = *find("version");
  const std::string known = std::to_string(newestVersion);
  if (!isWhole(version)) {
    const std::string found = version.is_number() ? version.dump() : jsonTypeName(version);
    report(Phrase::of("must be the whole number %1, not %2", known, found), placeOf("version"));
  } else if (version > newestVersion) {
    report(Phrase::of("%1 is newer than the version this program reads (%2): open it with a newer Alidade",
                      version.dump(), known),
           placeOf("version"));
  } else if (version != newestVersion) {
    report(Phrase::of(format.noVersion, version.dump(), known), placeOf("version"));
  }
}

void ObjectReader::report(const std::string& what, const Place& where) const {
  if (!m_problem) m_problem = Problem{what, where};
}

const ObjectReader::Json* ObjectReader::find(std::string_view wanted) const {
  if (!m_json.is_object()) return nullptr;
  for (const auto& [name, value] : m_json.get_ref<const Json::object_t&>())
    if (name == wanted) return &value;
  return nullptr;
}

Place ObjectReader::placeOf(std::string_view key) const {
  Place place = m_where;
  place.field += (place.field.empty() ? "" : ".") + std::string(key);
  return place;
}

JsonOrigin ObjectReader::origin(const std::vector<const char*>& parts) const {
  if (!m_json.is_object()) return {};
  Json kept = Json::object();
  auto& members = kept.get_ref<Json::object_t&>();
  for (const auto& [key, value] : m_json.get_ref<const Json::object_t&>()) {
    const bool part = std::find(parts.begin(), parts.end(), key) != parts.end();
    static_cast<std::vector<Json::object_t::value_type>&>(members).emplace_back(key, part ? Json() : value);
  }
  return JsonOrigin(kept);
}

}  // namespace alidade
