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
  Optional,  ///< left out where there is nothing to say
  Required,  ///< written even where empty
};

/// Brings the object a part was read from up to date, and touches nothing that did not change.
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

  /// Written where it has content or was there before.
  void part(const char* key, Json value, Presence presence = Presence::Optional);
  /// Left out where it is empty.
  void partIfAny(const char* key, Json value);
  /// How many rows there are, for the layout, which asks for each.
  void rows(const char* key, std::size_t count, Presence presence);
  /// A member that was there before keeps its JSON type.
  void list(const char* key, const std::vector<std::string>& current);

  Json take();

 private:
  std::unique_ptr<Json> m_json;  ///< the rest of the house does without its header
};

}  // namespace alidade
