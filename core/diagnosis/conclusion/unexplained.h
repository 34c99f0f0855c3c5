#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

// What the explanations of an inquiry leave without an explanation, as a probability and as an uncertainty of
// Δd. Both follow the posterior of all explanations, not the one that is told, so that neither jumps where
// one explanation overtakes another.
//
// Whether one explanation e accounts for a misclosure m with standard uncertainty s is weighed by the Bayes
// factor of something more that opened it, of the size that suits it best, τ² = m² − s², against nothing
// more: with z = |m|/s,
//
//   B(z) = N(m; 0, s² + τ²)/N(m; 0, s²) = exp((z² − 1)/2)/z for z > 1, else 1.
//
// The prior odds of something more are those at which B is even where a closure is said to fail (`fails`, a
// risk of 0.1 %, z = 3.29): q = B(z)/(B(z) + B(3.29)). z is that of the closure's chance, hence of Student's
// distribution. Of the residuals as a whole q is the same of the chance of their χ². With the posterior p(e):
//
// - chance = Σ p(e) × (1 where e holds a pattern of no cause, else the largest q of e). Where every effect at
//   its plausible size may be there instead of a pattern, that is one more e, with its share of the patterns;
// - sigma² = Σ p(e) Σ q (m² − s²)/4 over the e without a pattern; what a pattern moves Δd by is in the
//   accounts of Δd (`averaged`). What opened a closure without a name is no likelier to act on the x or
//   the radius of a position than on its y. So what it does to y(180°) − y(0°) is of the size m, and Δd is
//   half of that. Against the reference it is Δd itself that is off, by m.
//
// The first sum is over all explanations, q over the likeliest five without a pattern, each fitted.
//
// Source of the bound on a Bayes factor: Edwards, Lindman, Savage, "Bayesian statistical inference for
// psychological research", Psychological Review 70 (1963).

/// With repeats (`repeatsOf`).
std::vector<Closure> everyClosureOf(const GapModel& model);

/// Probability, 0…1, that more than chance is behind what chance has by `chance` (0…1): q above, ½ at 0.1 %.
double chanceOfMore(double chance);

/// `reference`: what Δd as measured leaves of it, where one is stated with its σ.
Unexplained unexplainedOf(const Inquiry& inquiry, const Answer& answer,
                          const std::optional<Closure>& reference);

}  // namespace alidade
