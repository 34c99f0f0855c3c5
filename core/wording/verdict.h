#pragma once

#include <string>

#include "core/adjustment/result/session_fit.h"

namespace alidade {

// The verdict of an acceptance, for a customer. Lengths in mm.

/// What the verdict of the fit rests on, or why it is withheld; empty where there is none. `measurement` is
/// what was fitted.
std::string verdictSentence(const Measurement& measurement, const SessionFit& fit);

/// What `decide` decides, with the numbers it rests on. `expanded` ≥ 0, `tolerance` > 0, `coverage` in (0,
/// 1).
std::string verdictSentence(double value, double expanded, double tolerance, double coverage);

}  // namespace alidade
