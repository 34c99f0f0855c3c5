#include "core/session/json_object_writer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace alidade {

ObjectWriter::ObjectWriter(const JsonOrigin& origin) : m_json(std::make_unique<Json>(origin.object())) {}

ObjectWriter::~ObjectWriter() = default;

ObjectWriter::Json ObjectWriter::take() {
  return std::move(*m_json);
}

void ObjectWriter::set(std::string_view key, const std::string& current, ValueKind kind, Presence presence) {
  const auto found = m_json->find(key);
  const bool present = found != m_json->end();
  if (present && textOf(*found, kind) == current) return;
  if (!current.empty() || presence == Presence::Required) {
    (*m_json)[key] = valueOf(current, kind);
  } else if (present) {
    m_json->erase(key);
  }
}

void ObjectWriter::flag(std::string_view key, bool current) {
  const auto found = m_json->find(key);
  const bool before = found != m_json->end() && *found == true;
  if (before != current) (*m_json)[key] = current;
}

void ObjectWriter::constant(const char* key, Json value) {
  if (!m_json->contains(key)) (*m_json)[key] = std::move(value);
}

void ObjectWriter::part(const char* key, Json value, Presence presence) {
  const bool wanted = presence == Presence::Required || !value.empty();
  if (wanted || m_json->contains(key)) (*m_json)[key] = std::move(value);
}

void ObjectWriter::partIfAny(const char* key, Json value) {
  if (value.empty())
    m_json->erase(key);
  else
    (*m_json)[key] = std::move(value);
}

void ObjectWriter::rows(const char* key, std::size_t count, Presence presence) {
  if (count > 0 || presence == Presence::Required || m_json->contains(key)) (*m_json)[key] = count;
}

void ObjectWriter::list(const char* key, const std::vector<std::string>& current) {
  const auto found = m_json->find(key);
  const Json before = found == m_json->end() ? Json::array() : *found;
  const std::vector<std::string> texts = entriesOf(before);
  if (texts == current) return;
  Json members = Json::array();
  for (const std::string& text : current) {
    const auto same = std::find(texts.begin(), texts.end(), text);
    const auto index = static_cast<std::size_t>(same - texts.begin());
    members.push_back(same == texts.end() ? Json(text) : before[index]);
  }
  (*m_json)[key] = std::move(members);
}

}  // namespace alidade
