#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/diagnosis/discover.h"
#include "core/evaluation/gap.h"

namespace alidade::console {

/// The whole diagnosis: verdict, stages, causes, known sizes, where the gap lies, closures, what to measure
/// next, undetectable effects and findings. `gap` must have a diagnosis.
std::string diagnosisText(const std::string& session, const Gap& gap, const std::vector<Finding>& findings);

/// Returns the forms with their look-alikes and the shrinkage of the gap; empty without forms.
std::string formsText(const std::vector<FoundForm>& forms);
/// The result of `discover` as text. `table` is the name of the table of residuals.
std::string discoveryText(const std::string& table, const Discovery& discovery);

}  // namespace alidade::console
