#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/problem.h"

namespace alidade {

/// Parses JSON text (UTF-8, with or without a byte order mark) into `json`, the order of the keys kept.
/// Refuses, with line and column or the place: what is not UTF-8 or not JSON, a key that stands twice in one
/// object (one of its values would be lost), and nesting deeper than 100.
std::optional<Problem> parseJson(std::string_view text, nlohmann::ordered_json& json);

/// JSON as the text of a session file: indented by two blanks, one line per reading and per pointing zero, a
/// newline at the end.
std::string layoutJson(const nlohmann::ordered_json& json);

}  // namespace alidade
