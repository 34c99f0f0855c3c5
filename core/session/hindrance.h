#pragma once

#include <vector>

#include "core/base/problem.h"
#include "core/session/session.h"

namespace alidade {

/// Of the entries of a session that cannot be used those that a number rests on. None rests on a date, and on
/// the temperature only where a length expands: result and verdict stand without them.
std::vector<Problem> hindrances(const Session& session, const std::vector<Problem>& problems);

}  // namespace alidade
