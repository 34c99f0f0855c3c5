#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/problem.h"

namespace alidade {

/// Receives each member of `positions[…].readings`, of any type, as soon as it is read.
using TakeRow = std::function<void(const Place& where, const nlohmann::ordered_json& row)>;

/// Parses JSON text (UTF-8, with or without a byte order mark) into `json`, keeping the order of the keys.
/// Refuses, with line and column or the place: invalid UTF-8 or JSON, a duplicate key in an object (one of
/// its values would be lost), and content beyond the limits (core/base/limits.h). With `takeRow`, the rows of
/// readings are passed to it in order and their lists in `json` stay empty. All rows at once would take many
/// times the memory of their text.
std::optional<Problem> parseJson(std::string_view text, nlohmann::ordered_json& json,
                                 const TakeRow& takeRow = {});

/// Creates a row of a position when it is written: a document with all rows would take many times the memory
/// of their text.
using RowsOf = std::function<nlohmann::ordered_json(std::size_t position, std::size_t row)>;

/// JSON as the text of a session file: indented by two blanks, one line per reading, zero and journal entry,
/// a newline at the end. With `rows`, `readings` is a position's number of rows, which `rows` creates.
std::string layoutJson(const nlohmann::ordered_json& json, const RowsOf& rows = {});

}  // namespace alidade
