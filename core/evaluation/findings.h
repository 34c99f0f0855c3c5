#pragma once

#include <vector>

#include "core/base/finding.h"
#include "core/evaluation/evaluation.h"

namespace alidade {

/// Findings about the fit, or reasons for its absence, in sentences; without the suspects.
std::vector<Finding> findingsOf(const Evaluation& evaluation);

}  // namespace alidade
