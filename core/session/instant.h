#pragma once

#include <optional>
#include <string_view>

namespace alidade {

/// A moment such as `2026-03-01T10:12:13.5+01:00` (ISO 8601) in minutes since 1970-01-01T00:00Z. A blank may
/// replace the T; missing seconds are 0, and a missing zone counts as UTC. Absent for other texts.
std::optional<double> minutesOf(std::string_view text);

}  // namespace alidade
