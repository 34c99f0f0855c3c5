#pragma once

#include <QString>
#include <optional>

#include "core/diagnosis/result/diagnosis.h"
#include "ui/jobs/evaluation.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

/// The verdict as window and report state it. A session with entries that could not be used gets none,
/// whatever the rest says.
struct VerdictText {
  QString word;  ///< "Accepted", "Rejected", "Undecided"; "…, fit only" without a diagnosis; or that there is
                 ///< none
  QString sentence;                     ///< with the numbers it rests on, or why there is none
  std::optional<Verdict> verdict = {};  ///< absent where there is none, and without a diagnosis
  bool tellsAcross = false;             ///< the sentence has what lies across the plane of the arc
};

/// `diagnosis` is of the evaluation; null: there was none.
VerdictText verdictText(const Evaluation& evaluation, const Diagnosis* diagnosis);
/// While the diagnosis is running: neither accept nor reject.
VerdictText provisionalVerdict(const Evaluation& evaluation);

/// In which colour it is shown.
State stateOf(const VerdictText& verdict);

/// "1.31 ± 0.21 mm": beside a tolerance with so many digits that they do not say otherwise than the
/// verdict.
QString intersectionText(const Measurement& measurement, double value, double expanded);

}  // namespace alidade::ui
