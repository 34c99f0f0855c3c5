#pragma once

#include <optional>
#include <vector>

#include "core/diagnosis/conclusion/answer.h"

namespace alidade {

/// Averages Δd over the explanations found and the look-alikes of each cause, weighted by probability. If the
/// answer is larger noise, explanations that add a cause to it do not count. σ includes the differences of Δd
/// between the explanations. U is kσ, or larger if ± kσ does not reach the coverage in the averaged
/// distribution. Returns Δd of the answer unchanged if the alternatives hardly change it. With an unknown
/// cause, the average is over look-alikes only, and σ includes the change of Δd by the pattern.
std::optional<IntersectionEstimate> modelAveragedIntersection(const Inquiry& inquiry, const Answer& answer);

/// An alternative to the explanation of an estimate.
struct Possible {
  double odds = 1;                 ///< relative to the estimate's explanation
  double value = 0, variance = 0;  ///< of Δd, minus value and variance of the estimate: mm, mm²
};

/// Averages `own` over alternatives, which include its own explanation. Returns `own` unchanged if the
/// average hardly differs.
IntersectionEstimate averagedOver(const IntersectionEstimate& own, const std::vector<Possible>& all,
                                  double coverage);

/// Returns `own` with `variance`, mm², added to its σ². A negative `variance` counts as 0.
IntersectionEstimate widerBy(IntersectionEstimate own, double variance);

/// Returns an explanation and its variants, in which rivals of the answer replace parts. Rivals with odds
/// below 10⁻³ are ignored. Each variant has its own odds.
std::vector<Explanation> withRivals(const Answer& answer, const Explanation& explanation);

/// The inquiry's explanation from which an answer was made; null if there is none.
const Explanation* explanationOf(const Inquiry& inquiry, const Answer& answer);

/// Whether an explanation counts in the average. The readings must support each of its parts, since
/// undetectable effects are reported separately. It must not add causes to an answer of larger noise.
bool isInAverage(const Explanation& explanation, const Answer& answer);

}  // namespace alidade
