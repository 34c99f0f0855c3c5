#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/json_origin.h"
#include "core/session/value_text.h"

namespace alidade {

enum class Presence {
  Optional,  ///< omitted if empty
  Required,  ///< written even if empty
};

/// Updates the JSON object from which a part was read. Members whose values did not change stay as they were.
class ObjectWriter {
 public:
  using Json = nlohmann::ordered_json;

  explicit ObjectWriter(const JsonOrigin& origin);
  ~ObjectWriter();

  void set(std::string_view key, const std::string& current, ValueKind kind, Presence presence);
  void text(const char* key, const std::string& current) {
    set(key, current, ValueKind::Text, Presence::Optional);
  }
  void number(const char* key, const std::string& current, Presence presence = Presence::Optional) {
    set(key, current, ValueKind::Number, presence);
  }
  void angle(const char* key, const std::string& current, Presence presence = Presence::Optional) {
    set(key, current, ValueKind::Angle, presence);
  }
  void flag(std::string_view key, bool current);
  void constant(const char* key, Json value);

  /// Writes `value` if it is required, is not empty or existed before.
  void part(const char* key, Json value, Presence presence = Presence::Optional);
  /// Writes `value`; if it is empty, removes the key.
  void partIfAny(const char* key, Json value);
  /// Writes the number of rows, which `layoutJson` replaces by the rows.
  void rows(const char* key, std::size_t count, Presence presence);
  /// Writes a list of texts. Entries that existed before keep their JSON type.
  void list(const char* key, const std::vector<std::string>& current);

  Json take();

 private:
  std::unique_ptr<Json> m_json;  ///< by pointer, so that other files do not include its header
};

}  // namespace alidade
