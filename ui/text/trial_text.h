#pragma once

#include <QString>

#include "core/simulation/blind_trial.h"
#include "core/simulation/trial_score.h"

namespace alidade::ui {

/// The common name of a kind of truth: "collimation", "two effects", "nothing".
QString trialKindName(const std::string& kind);

/// A line for each simulated error, or "No error was simulated."; then the size of their trace in the
/// readings, in σ, and the true Δd.
QStringList truthLines(const BlindTrial& trial);

/// Says why the diagnosis counts as right or wrong, and whether Δd covers the true Δd, if that was checked.
QString scoreSentence(const SealedTruth& truth, const TrialScore& score);

}  // namespace alidade::ui
