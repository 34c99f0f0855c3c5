#pragma once

#include <vector>

#include "core/adjustment/session_fit.h"

namespace alidade {

/// What the session as a whole says about itself, beyond its single arcs: a missing position, radii of one
/// rigid guideway that differ, a result away from the reference, entries that these fits do not use.
std::vector<Finding> sessionFindings(const Measurement& measurement, const SessionFit& fit);

}  // namespace alidade
