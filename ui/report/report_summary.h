#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/acceptance_report.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// Parts for which the front page may lack room. True: no later page needs the part, since it is on the front
/// page or left out of the report.
struct FrontPage {
  bool hasMethod = false, isSigned = false;
};

/// The front page: people, device, dates and equipment; the result with verdict and terms; method and
/// signatures if there is room. Empty fields are left out.
FrontPage addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options);

/// Adds the method to a page that is more than half full if the method fits. False: the method was not added.
bool addMethodInTheRest(ReportSheet& sheet, const Evaluation& evaluation);

/// The signature lines, with the names that the session states.
void addSignatures(ReportSheet& sheet, const Session& session);

/// The section on how the numbers were computed.
void addMethod(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
