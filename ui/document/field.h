#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade::ui {

/// A single editable text of the session: its name in the session file, the noun of undo texts, and an
/// accessor. Fields of the whole session ignore `position`.
struct Field {
  std::string_view name;
  const char* noun;
  std::function<const std::string&(const Session& session, std::size_t position)> get;
  std::function<std::string&(Session& session, std::size_t position)> at;
  bool isOfPosition = true;  ///< true: one text per position; false: one for the session
};

/// Every field, in the order of the session file.
std::span<const Field> allFields();

/// The field with this name, without indices, such as `geometry.distance_mm` or `pointing_zero.vertical`.
/// Null if no field has the name. Cells of readings are not fields.
const Field* fieldNamed(std::string_view name);

/// The text of the field at `place`; empty if the session has no such place.
std::string fieldText(const Session& session, const Place& place);

}  // namespace alidade::ui
