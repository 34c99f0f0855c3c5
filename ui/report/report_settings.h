#pragma once

#include "ui/report/report_choice.h"

namespace alidade::ui {

/// The last choice on this machine; invalid stored values are ignored.
ReportChoice rememberedReportChoice();
void rememberReportChoice(const ReportChoice& choice);

}  // namespace alidade::ui
