#pragma once

#include "core/evaluation/gap.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

/// The diagnosis: the verdict, each stage of the gap with Δd, and the causes with their numbers. Empty if
/// model and readings agree and the model has no effects. Also empty for larger noise alone, which is a
/// finding.
void addGap(ReportSheet& sheet, const Gap& gap);

/// The closures with their misclosures, fit only and with the causes. With a reference that has a σ, also the
/// size of each effect that would explain Δd − reference. Empty if there are no closures.
void addClosures(ReportSheet& sheet, const Gap& gap);

/// Limits of Δd ± U: undetectable effects in these readings, the change of Δd by a plausible size of each,
/// and further readings to detect them.
void addUndetectable(ReportSheet& sheet, const Gap& gap);

}  // namespace alidade::ui
