#pragma once

#include "core/statement/headline.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

/// The state of the verdict. `Quiet` if there is no verdict, or if it is from the fit only.
State stateOf(const Headline& headline);

}  // namespace alidade::ui
