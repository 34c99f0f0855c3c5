#pragma once

#include <string>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/intersection.h"
#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"
#include "core/statement/statement.h"

namespace alidade {

/// The budget of Δd, measured, largest share first. Shares below `leastShare` of the variance are combined in
/// one row, if there are at least two. Lengths are in mm, with one digit more than u needs. The sensitivity
/// of an effect is its u divided by the 1σ of its numbers, in mm per unit of the numbers: |∂Δd/∂x| for one
/// number, the root of the sum of squares for several of one size. `coverage` is that of U, 0…1.
Statement measuredBudget(const Diagnosis& diagnosis, double coverage);

/// The budget of Δd, fit only: readings, model effects, known radius, pointing zeros and distance. `fit` has
/// an intersection.
Statement fitBudget(const SessionFit& fit);

/// The budget of the centre of each arc: the same sources, and the correlation with the radius. Without rows
/// if no arc was fitted.
Statement centreBudget(const SessionFit& fit);

/// The parts of U, for a reader who has only the result: its coverage, then u and ν of Δd, measured, and of
/// Δd, fit only. `fitOnly`: the text of Δd, fit only. `fit` has an intersection; a null `diagnosis` means
/// that none was made.
std::string coverageSentences(const SessionFit& fit, const Diagnosis* diagnosis, const std::string& fitOnly);

/// One percent: a smaller part of the variance changes u by less than half a percent.
constexpr double leastShare = 0.01;

/// The share of the variance of σ `whole` due to σ `part`: "63.1 %"; an em dash if `whole` is not positive.
std::string varianceShare(double part, double whole);

/// "k = 2.00, 95 % coverage".
std::string coverageWithFactor(double factor, double coverage);

/// "95 %", "99.73 %": a probability.
std::string coverageText(double coverage);

/// "7.2", "12", "many" above ten thousand, "∞".
std::string degreesOfFreedomText(double degrees);

/// Δd, fit only, by linear propagation and from the draws, then the centres from the draws: mean, u and the
/// ends of the interval, in mm. `linear` is null without an intersection.
Statement monteCarloCheck(const MonteCarlo& check, const Intersection* linear);

/// Whether propagated and simulated uncertainty agree: "Agrees."
std::string agreementWord(const MonteCarlo& check);

/// States the difference of the interval ends, its tolerance, and the consequence.
std::string agreementSentence(const MonteCarlo& check);

}  // namespace alidade
