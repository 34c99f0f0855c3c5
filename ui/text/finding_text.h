#pragma once

#include <vector>

#include "core/base/finding.h"
#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// What stands against the fit, or in its place, in sentences; the suspects apart.
std::vector<Finding> findingsOf(const Evaluation& evaluation);

}  // namespace alidade::ui
