#pragma once

#include <QDateTime>
#include <optional>
#include <string>

#include "ui/jobs/instrument_job.h"
#include "ui/report/report_paper.h"

namespace alidade::ui {

/// An instrument check as PDF/A-3b, with its JSON attached: the verdict, the instrument with its dates,
/// results by station, their course, and every finding. `answer` must have a check. Absent: painting failed.
std::optional<std::string> checkPdf(const CheckedInstrument& answer, const ReportPaper& paper = {},
                                    const QDateTime& date = QDateTime::currentDateTime());

}  // namespace alidade::ui
