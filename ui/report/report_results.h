#pragma once

#include <optional>
#include <string>

#include "core/evaluation/gap.h"

namespace alidade::ui {

/// The results of the report for other programs: the output of `alidade-cli fit --json` for the session,
/// named `name`, always in English. Absent if an entry is unusable or an arc was not fitted.
std::optional<std::string> resultsJson(const Gap& gap, const std::string& name);

}  // namespace alidade::ui
