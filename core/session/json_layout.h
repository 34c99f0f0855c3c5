#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// A row of a position, created when it is written: a document with all rows would take many times the memory
/// of their text.
using RowsOf = std::function<nlohmann::ordered_json(std::size_t position, std::size_t row)>;

/// JSON as the text of a session file: indented by two blanks, one line per reading and per pointing zero, a
/// newline at the end. With `rows`, the `readings` of a position hold their number, and `rows` creates them.
std::string layoutJson(const nlohmann::ordered_json& json, const RowsOf& rows = {});

}  // namespace alidade
