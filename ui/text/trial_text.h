#pragma once

#include <QString>

#include "core/simulation/blind_trial.h"
#include "core/simulation/trial_score.h"

namespace alidade::ui {

/// A kind of truth as people call it: "collimation", "two effects", "nothing".
QString trialKindName(const std::string& kind);

/// What was put into the session, with sizes, a line for each thing; "Nothing was put in." where that is so.
QStringList truthLines(const BlindTrial& trial);

/// Why the answer counts as right or wrong, in a sentence.
QString scoreSentence(const SealedTruth& truth, const TrialScore& score);

}  // namespace alidade::ui
