#pragma once

#include <QString>
#include <optional>

#include "core/diagnosis/result/diagnosis.h"
#include "core/evaluation/evaluation.h"
#include "ui/settings/theme.h"

namespace alidade::ui {

/// The verdict in window and report. A session with unusable entries never has one.
struct VerdictText {
  QString word;  ///< "Accepted", "Rejected", "Undecided"; "…, fit only" without a diagnosis; or that there is
                 ///< none
  QString sentence;                     ///< with its numbers, or why there is none
  std::optional<Verdict> verdict = {};  ///< absent without a verdict or a diagnosis
  bool tellsAcross = false;             ///< the sentence includes Δz, across the plane of the arc
};

/// `diagnosis` belongs to the evaluation; null if there was none.
VerdictText verdictText(const Evaluation& evaluation, const Diagnosis* diagnosis);
/// The verdict while the diagnosis is running: neither accept nor reject.
VerdictText provisionalVerdict(const Evaluation& evaluation);

/// The state that sets its colour.
State stateOf(const VerdictText& verdict);

/// "1.31 ± 0.21 mm": with enough digits to agree with the verdict on a tolerance.
QString intersectionText(const Measurement& measurement, double value, double expanded);

}  // namespace alidade::ui
