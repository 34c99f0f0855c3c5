#pragma once

#include "core/statement/headline.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

/// The state of the verdict. Quiet without a verdict, or if the verdict is that of the fit only.
State stateOf(const Headline& headline);

}  // namespace alidade::ui
