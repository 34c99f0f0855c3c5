#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace alidade {

/// A row of a position, made when it is written: a document that held all of them would take many times
/// their text.
using RowsOf = std::function<nlohmann::ordered_json(std::size_t position, std::size_t row)>;

/// JSON as the text of a session file: indented by two blanks, one line per reading and per pointing zero, a
/// newline at the end. With `rows`, the `readings` of a position are their number, and it makes them.
std::string layoutJson(const nlohmann::ordered_json& json, const RowsOf& rows = {});

}  // namespace alidade
