#pragma once

#include <optional>
#include <vector>

#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade {

/// The `problems` of a session whose entries affect a number of the result. A date never affects a number;
/// the temperature affects one only if an expansion of a length is entered.
std::vector<Problem> hindrances(const Session& session, const std::vector<Problem>& problems);

/// The first of the `hindrances`, with the number of the others in its sentence; absent if there are none.
std::optional<Problem> firstHindrance(const Session& session, const std::vector<Problem>& problems);

}  // namespace alidade
