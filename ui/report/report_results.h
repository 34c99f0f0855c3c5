#pragma once

#include <optional>
#include <string>

#include "core/answers/fit_answer.h"
#include "ui/jobs/gap.h"

namespace alidade::ui {

/// The results that a report states, as a program reads them: what `alidade-cli fit --json` prints for the
/// session, called `name` there, always in English. Absent where the session has none: an entry cannot be
/// used, or not every arc was fitted.
std::optional<std::string> resultsJson(const Gap& gap, const std::string& name);

/// The same as a value, for what else is made of it. `name` and `gap` must outlive it.
std::optional<FitAnswer> fitAnswerOf(const Gap& gap, const std::string& name);

}  // namespace alidade::ui
