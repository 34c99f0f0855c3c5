#pragma once

#include <memory>

#include "core/evaluation/evaluation.h"
#include "core/evaluation/gap.h"
#include "ui/report/report_contents.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

class Plot;

// Each function adds one part of a report to the sheet; an empty part adds nothing.

/// The headline in a frame: the result in large type, its place on the scale of the tolerance, notes, and the
/// number of findings; then, in small type, the reason of the verdict and Δd, fit only.
void addVerdict(ReportSheet& sheet, const Gap& gap);

/// Every unusable entry, with a red bar at its left; empty if all entries are usable.
void addProblems(ReportSheet& sheet, const Evaluation& evaluation);

/// The arcs with standard uncertainties, the estimated effects, and the instrument errors from both faces.
void addResult(ReportSheet& sheet, const Gap& gap);

/// The budget of Δd, measured, then the budget of Δd, fit only; empty without an intersection.
void addUncertainty(ReportSheet& sheet, const Gap& gap);

/// The diagnosis: the verdict, each stage of the gap with Δd, and the causes with their numbers. Empty if
/// model and readings agree and the model has no effects. Also empty for larger noise alone, which is a
/// finding.
void addGap(ReportSheet& sheet, const Gap& gap);

/// The closures with their misclosures, fit only and with the causes. With a reference that has a σ, also the
/// size of each effect that would explain Δd − reference. Empty if there are no closures.
void addClosures(ReportSheet& sheet, const Gap& gap);

/// Limits of Δd ± U: effects undetectable in these readings, the change of Δd by a plausible size of each
/// effect, and further readings to detect the effects.
void addUndetectable(ReportSheet& sheet, const Gap& gap);

/// Known sizes of instrument and device: each number with its u, source and date, and what these readings say
/// of it; the instrument record by name. Empty without known sizes.
void addKnown(ReportSheet& sheet, const Gap& gap);

/// The forms of effects outside the catalogue. Each form has a sentence, the range where the model holds, and
/// a curve. Empty if no form was found.
void addForms(ReportSheet& sheet, const Gap& gap);

/// A plot as vectors over the whole width, `height` mm high.
void addPlot(ReportSheet& sheet, const std::shared_ptr<Plot>& plot, double height);

/// The selected plots as vectors, by the drawing code of the screen, with captions; two plots share a page.
void addPlots(ReportSheet& sheet, const Gap& gap, bool hasArcs, bool hasResiduals);

/// Every reading as typed, position by position, with the adjusted arc angle and the residuals.
void addReadings(ReportSheet& sheet, const Evaluation& evaluation);

/// The rows that a report lists even without the other readings: changed, excluded or unusable rows. Empty if
/// no row is changed, excluded or unusable.
void addRemarkableReadings(ReportSheet& sheet, const Evaluation& evaluation);

/// Recorded changes in order, whether the journal is complete, and whether the session is sealed; empty
/// without a journal.
void addJournal(ReportSheet& sheet, const Evaluation& evaluation);

/// The terms of the result: the measurand and its sign; the decision rule, its risk and who agreed it, if a
/// verdict is possible; the protocol, if there is one, and where the session departs from it; excluded rows,
/// counted by note; corrections; the temperature, if stated, and its use; what a report should state
/// and the session does not; parts left out of the report.
void addTerms(ReportSheet& sheet, const Gap& gap, const ReportContents& contents);

}  // namespace alidade::ui
