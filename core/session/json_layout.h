#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// Creates a row of a position when it is written: a document with all rows would take many times the memory
/// of their text.
using RowsOf = std::function<nlohmann::ordered_json(std::size_t position, std::size_t row)>;

/// JSON as the text of a session file: indented by two blanks, one line per reading, zero and journal entry,
/// a newline at the end. With `rows`, `readings` is a position's number of rows, which `rows` creates.
std::string layoutJson(const nlohmann::ordered_json& json, const RowsOf& rows = {});

}  // namespace alidade
