#pragma once

#include <string>

#include "core/self_test/self_test.h"

namespace alidade::console {

/// The self-test to be read and filed: program and time, machine and libraries, line by line what was
/// expected and found, each tolerance with its reason, and the verdict.
std::string selfTestText(const SelfTest& test, const std::string& program, const std::string& at);

}  // namespace alidade::console
