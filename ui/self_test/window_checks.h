#pragma once

#include <vector>

#include "core/self_test/self_check.h"

namespace alidade::ui {

/// What the window's program holds in itself and takes from the machine: the samples of the start page, the
/// guide in every language, the languages, and the fonts of reports.
std::vector<SelfCheck> windowChecks();

}  // namespace alidade::ui
