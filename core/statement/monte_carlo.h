#pragma once

#include <string>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/intersection.h"
#include "core/statement/statement.h"

namespace alidade {

/// Δd, fit only, by linear propagation and from the draws, then the centres from the draws: mean, u and the
/// ends of the interval, in mm. `linear` is null without an intersection.
Statement monteCarloCheck(const MonteCarlo& check, const Intersection* linear);

/// Whether propagated and simulated uncertainty agree: "Agrees."
std::string agreementWord(const MonteCarlo& check);

/// States the difference of the interval ends, its tolerance, and the consequence.
std::string agreementSentence(const MonteCarlo& check);

}  // namespace alidade
