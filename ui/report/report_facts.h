#pragma once

#include <QDateTime>

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Device, people and dates beside instrument and geometry, as stated in the session.
void addFacts(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date);

}  // namespace alidade::ui
