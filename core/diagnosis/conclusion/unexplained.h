#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// The part of a gap without an explanation, as a probability and as an uncertainty of Δd. Both follow the
// posterior of all explanations, not only of the reported one, so that neither changes abruptly when one
// explanation overtakes another.
//
// A misclosure m with standard uncertainty s may have a further cause in addition to explanation e. The
// evidence is the Bayes factor of a further cause of the best-fitting size, τ² = m² − s², against none: with
// z = |m|/s,
//
//   B(z) = N(m; 0, s² + τ²)/N(m; 0, s²) = exp((z² − 1)/2)/z for z > 1, else 1.
//
// The prior odds make a further cause and none equally probable at the limit of a failing closure (`fails`, a
// risk of 0.1 %, z = 3.29): q = B(z)/(B(z) + B(3.29)). z follows from the closure's probability, which comes
// from Student's distribution. For the residuals as a whole, q follows from the probability of their χ². With
// the posterior p(e):
//
// - chance = Σ p(e) × (1 if e contains a pattern without a cause, else the largest q of e). If every effect
//   at its plausible size is an alternative to the patterns, it is one more e and shares their probability;
// - sigma² = Σ p(e) Σ q (m² − s²)/4 over the e without a pattern; the change of Δd by a pattern is in the
//   explanations of Δd (`averaged`). An unnamed cause of a misclosure in x or radius may equally act on y of
//   a position: it changes y(180°) − y(0°) by m, and Δd by m/2. A misclosure of Δd against the reference is a
//   deviation of Δd by m.
//
// The first sum is over all explanations. q is computed by a fit for each of the likeliest explanations
// without a pattern, at most five.
//
// Source of the bound on a Bayes factor: Edwards, Lindman, Savage, "Bayesian statistical inference for
// psychological research", Psychological Review 70 (1963).

/// The closures of a model, repeats (`repeatsOf`) included.
std::vector<Closure> everyClosureOf(const GapModel& model);

/// Probability, 0…1, of a further cause of a deviation that noise alone exceeds with probability `chance`.
/// It is q above; for a `chance` of 0.1 % it is ½.
double chanceOfMore(double chance);

/// `reference` is the misclosure of Δd, measured, against a reference that is stated with its σ.
Unexplained unexplainedOf(const Inquiry& inquiry, const Answer& answer,
                          const std::optional<Closure>& reference);

}  // namespace alidade
