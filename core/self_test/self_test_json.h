#pragma once

#include <string>

#include "core/self_test/self_test.h"

namespace alidade {

/// {"at", "verdict": "pass"|"fail", "passed", "failed", "left_out", "environment": {name: value},
/// "checks": [{"group", "name", "expected", "found", "deviation", "tolerance", "reason", "outcome": "passed"|
/// "failed"|"left-out"}], "program": {"name", "version", "build"}}. `deviation` and `tolerance` are relative
/// to `expected`, and null for values that are not numbers.
std::string selfTestJson(const SelfTest& test, const std::string& at);

}  // namespace alidade
