#pragma once

#include <QDateTime>
#include <vector>

#include "ui/jobs/evaluation.h"
#include "ui/report/report_sheet.h"

namespace alidade::ui {

struct LabelledText {
  QString label, text;
};

/// Those that have a text, below one another, labels beside them; answers where they end. Lengths in mm.
double placeLabelled(ReportSheet& sheet, const std::vector<LabelledText>& texts, double left, double top,
                     double available);

/// The height they take up.
double labelledHeight(const ReportSheet& sheet, const std::vector<LabelledText>& texts, double available);

/// Laboratory, device, people and dates beside instrument and geometry, as far as the session states them; of
/// each σ whether it is stated or the program's default.
void addFacts(ReportSheet& sheet, const Evaluation& evaluation, const QDateTime& date);

}  // namespace alidade::ui
