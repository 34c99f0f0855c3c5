#pragma once

#include <string>

#include "core/self_test/self_test.h"

namespace alidade::console {

/// The self-test as text for filing: program and time, machine and libraries, each expected and found value,
/// each tolerance with its reason, and the verdict.
std::string selfTestText(const SelfTest& test, const std::string& program, const std::string& at);

}  // namespace alidade::console
