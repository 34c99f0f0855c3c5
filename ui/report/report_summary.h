#pragma once

#include "ui/jobs/gap.h"
#include "ui/report/acceptance_report.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// What a front page may have no room for; true, too, where it is left out.
struct FrontPage {
  bool hasMethod = false, isSigned = false;
};

/// The front page: who, what, when and with what; the result with its verdict and the terms it is stated on;
/// and method and signatures where there is room for them. What the session does not state is left out.
FrontPage addSummary(ReportSheet& sheet, const Gap& gap, const ReportOptions& options);

/// The method, where it fits what is left of a page and less than half of it is. False: it was not added.
bool addMethodInTheRest(ReportSheet& sheet, const Evaluation& evaluation);

/// The lines to be signed, with the names that the session states.
void addSignatures(ReportSheet& sheet, const Session& session);

/// How the numbers were made.
void addMethod(ReportSheet& sheet, const Evaluation& evaluation);

}  // namespace alidade::ui
