#pragma once

#include <QDateTime>
#include <vector>

#include "core/evaluation/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

struct LabelledText {
  QString label, text;
};

/// Places the non-empty texts below each other with labels at their left; returns the lower end. Lengths in
/// mm.
double placeLabelled(ReportSheet& sheet, const std::vector<LabelledText>& texts, double left, double top,
                     double available);

/// The height of the texts as `placeLabelled` places them, mm.
double labelledHeight(const ReportSheet& sheet, const std::vector<LabelledText>& texts, double available);

/// Adds what the session states: laboratory, device, people and dates at the left, instrument and geometry at
/// the right. Each σ is marked as stated or as the default.
void addFacts(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date);

}  // namespace alidade::ui
