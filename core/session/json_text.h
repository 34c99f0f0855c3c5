#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

#include "core/base/problem.h"

namespace alidade {

/// Takes a member of `positions[…].readings`, whatever it is, as soon as it is read.
using TakeRow = std::function<void(const Place& where, const nlohmann::ordered_json& row)>;

/// Parses JSON text (UTF-8, with or without a byte order mark) into `json`, the order of the keys kept.
/// Refuses, with line and column or the place: what is not UTF-8 or not JSON, a key that stands twice in one
/// object (one of its values would be lost), and what is beyond the limits (core/base/limits.h). With
/// `takeRow`, the rows of readings are handed to it in their order and are no part of `json`, where their
/// lists are empty: all of them at once would take many times their text.
std::optional<Problem> parseJson(std::string_view text, nlohmann::ordered_json& json,
                                 const TakeRow& takeRow = {});

}  // namespace alidade
