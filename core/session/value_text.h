#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace alidade {

/// The kinds of values of the session file that are kept as text and converted back to JSON.
enum class ValueKind {
  Text,    ///< a JSON string
  Number,  ///< a JSON number; a string if the typed text is not a number
  Angle,   ///< a JSON string as typed; a JSON number is decimal degrees, `341.873333°` as text
};

/// The text of a JSON value; empty if its JSON type is wrong for the kind.
std::optional<std::string> textOf(const nlohmann::ordered_json& value, ValueKind kind);

/// The JSON value for a typed text.
nlohmann::ordered_json valueOf(const std::string& text, ValueKind kind);

/// The text after writing to a file and reading it back: the number 1.0 becomes 1.
std::string filedText(const std::string& text, ValueKind kind);

/// The members of a JSON list as texts; other types than strings as their JSON.
std::vector<std::string> entriesOf(const nlohmann::ordered_json& list);

/// The required type of a value of this kind, for sentences: "a number", …
std::string wantedType(ValueKind kind);

}  // namespace alidade
