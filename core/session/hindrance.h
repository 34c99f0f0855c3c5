#pragma once

#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade {

/// The unusable entries of a session that affect a number. A date never does, and the temperature only if a
/// length expands: result and verdict are independent of them.
std::vector<Problem> hindrances(const Session& session, const std::vector<Problem>& problems);

/// The first of them, with the number of the others; absent without any.
std::optional<Problem> firstHindrance(const Session& session, const std::vector<Problem>& problems);

}  // namespace alidade
