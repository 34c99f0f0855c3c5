#pragma once

#include <optional>
#include <string>

#include "ui/jobs/gap.h"

namespace alidade::ui {

/// The results that a report states, as a program reads them: what `alidade-cli fit --json` prints for the
/// session, called `name` there, always in English. Absent where the session has none: an entry cannot be
/// used, or not every arc was fitted.
std::optional<std::string> resultsJson(const Gap& gap, const std::string& name);

}  // namespace alidade::ui
