#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/acceptance_report.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Parts that the front page may lack room for. True: the part is on it, or is not printed.
struct FrontPage {
  bool hasMethod = false, isSigned = false;
};

/// The front page: people, device, dates and equipment; the result with verdict and terms; method and
/// signatures if there is room. Empty fields are left out.
FrontPage addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options);

/// Adds the method if it fits the rest of a page and takes less than half of it. False: it was not added.
bool addMethodInTheRest(ReportSheet& sheet, const Evaluation& evaluation);

/// The signature lines, with the names that the session states.
void addSignatures(ReportSheet& sheet, const Session& session);

/// How the numbers were computed.
void addMethod(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
