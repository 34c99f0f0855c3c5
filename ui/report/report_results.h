#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/evaluation/gap.h"

namespace alidade::ui {

/// The results of the report for other programs: the output of `alidade-cli fit --json` for the session,
/// named `name`, whose file has the bytes `file`; always in English. Absent if an entry is unusable or an arc
/// was not fitted.
std::optional<std::string> resultsJson(const Gap& gap, const std::string& name, std::string_view file);

}  // namespace alidade::ui
