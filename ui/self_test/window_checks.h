#pragma once

#include <vector>

#include "core/self_test/self_check.h"

namespace alidade::ui {

/// Checks that only the program with a window can make: the samples of the start page, the guide in every
/// language, the languages, and the fonts of reports.
std::vector<SelfCheck> windowChecks();

}  // namespace alidade::ui
