#pragma once

#include "ui/report/report_choice.h"

namespace alidade::ui {

/// As chosen last, on this machine; what is stored and means nothing counts as not chosen.
ReportChoice rememberedReportChoice();
void rememberReportChoice(const ReportChoice& choice);

}  // namespace alidade::ui
