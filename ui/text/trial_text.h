#pragma once

#include <QString>

#include "core/simulation/blind_trial.h"
#include "core/simulation/trial_score.h"

namespace alidade::ui {

/// The common name of a kind of truth: "collimation", "two effects", "nothing".
QString trialKindName(const std::string& kind);

/// The simulated errors of the session with sizes, a line for each; "No error was simulated." if none.
QStringList truthLines(const BlindTrial& trial);

/// A sentence on why the diagnosis counts as right or wrong.
QString scoreSentence(const SealedTruth& truth, const TrialScore& score);

}  // namespace alidade::ui
