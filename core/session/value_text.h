#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace alidade {

/// How a value of the session file is kept as text and becomes JSON again.
enum class ValueKind {
  Text,    ///< a JSON string
  Number,  ///< a JSON number; a string where what was typed is no number
  Angle,   ///< a JSON string as typed; a JSON number is decimal degrees, `341.873333°` as text
};

/// The text a JSON value is read as; empty where its JSON type is wrong for the kind.
std::optional<std::string> textOf(const nlohmann::ordered_json& value, ValueKind kind);

/// The JSON value a typed text is written as.
nlohmann::ordered_json valueOf(const std::string& text, ValueKind kind);

/// The members of a JSON list as texts; one that is no JSON string as its JSON.
std::vector<std::string> entriesOf(const nlohmann::ordered_json& list);

/// What a value of this kind must be, for sentences: "a number", …
std::string wantedType(ValueKind kind);

}  // namespace alidade
