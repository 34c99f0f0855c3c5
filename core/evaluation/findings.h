#pragma once

#include <vector>

#include "core/base/finding.h"
#include "core/evaluation/evaluation.h"

namespace alidade {

/// The findings of the fit, and why the fit or the search for suspects failed. Suspects are not included.
std::vector<Finding> findingsOf(const Evaluation& evaluation);

}  // namespace alidade
