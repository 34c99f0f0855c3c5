#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/evaluation/gap.h"

namespace alidade::console {

/// The whole diagnosis: verdict, stages, causes, known sizes, where the gap lies, closures, what to measure
/// next, undetectable effects and findings. `gap` must have a diagnosis.
std::string diagnosisText(const std::string& session, const Gap& gap, const std::vector<Finding>& findings);

}  // namespace alidade::console
