#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// The verdict of an acceptance in the light of the diagnosis, as a function of the evidence that has
// thresholds and no switches.
//
// 1. Both accounts have to say the same: Δd ± U of the session's own model, and what is believed of Δd as
//    measured.
// 2. Of the latter the guard band holds (`decide`: accept only if |Δd| + U ≤ T, reject only if |Δd| − U > T),
//    and so does the risk on either side of the tolerance, with c the coverage:
//
//      accept:  P(Δd > T) ≤ (1 − c)/2 and P(Δd < −T) ≤ (1 − c)/2,
//      reject:  P(Δd ≤ T) ≤ (1 − c)/2 or P(Δd ≥ −T) ≤ (1 − c)/2.
//
//    Of a single account Δd ± kσ with P(t ≤ k) = (1 + c)/2 these are the guard band itself, since P(Δd > T) =
//    (1 − c)/2 where Δd + kσ = T. Of several accounts, one of which lies far off, they are the stricter.
// 3. P is of the averaged accounts (`IntersectionEstimate`), each with the further standard uncertainty that
//    misclosures without an explanation bring (`Unexplained::sigma`). So a closure counts as explained with
//    the probability with which its cause is there.
// 4. The verdict is open where the gap is real and unexplained with a probability above `mostUnexplained`.
// 5. An undetectable effect of the catalogue is in U and in the probability, at its plausible size. A knock
//    that these readings would not show is a condition of the verdict: stated where the verdict would not
//    hold had one of plausible size occurred. The probability of conformity includes it, with its prior odds.

/// A guard band of a lower coverage guards against nothing.
constexpr double leastCoverageOfVerdict = 0.9;

/// An unexplained gap that is likelier, as good as certain, leaves the verdict open. Of 1000 simulated
/// sessions, half of them of no catalogue, 492 of the 508 `NotInCatalogue` are beyond; below lie what is
/// unclear and what one reading turns over, where U has room for either.
constexpr double mostUnexplained = 0.95;

struct AcceptanceDecision {
  /// What stands in the way of accept or reject.
  enum class Obstacle {
    None,
    Uncertainty,    ///< U, on both accounts
    Lengths,        ///< in doubt, so the verdict is withheld
    Coverage,       ///< U is stated at a coverage too low for a verdict
    Contradiction,  ///< the two accounts do not say the same
    AcrossUnknown,  ///< the tolerance is of the distance from the axis, of which a part was not measured
    Unexplained,    ///< the gap is real, and as good as certainly nothing of the catalogue explains it
  };

  Verdict verdict = Verdict::Undecided;
  /// By Δd ± U of the session's own model, which knows no more of a distance from the axis.
  Verdict asModelled = Verdict::Undecided;
  /// By what is believed of it as measured (2 and 3 above); absent without a diagnosis.
  std::optional<Verdict> asFound = {};
  Obstacle obstacle = Obstacle::Uncertainty;
  /// There are two accounts, that of the fit alone and that of the measurement: both belong beside the
  /// verdict.
  bool showsBoth = false;
  /// Probability that the measurand is within the tolerance, 0…1, by what is believed of it as measured, or
  /// of Δd without a diagnosis by the fit (`conformanceOf`); undetectable knocks included. Absent where the
  /// verdict is withheld, the gap is unexplained, U has no end, or a part was not measured.
  std::optional<double> conformance = {};
  /// Indices into `Diagnosis::undetectableJumps`: the verdict, accept or reject, would not stand had one of
  /// these knocks occurred in its plausible size.
  std::vector<std::size_t> conditions = {};

  bool operator==(const AcceptanceDecision&) const = default;
};

/// `fit` and `diagnosis` are of `measurement`; null: there was no diagnosis. Absent where the fit has no
/// verdict: without a tolerance or an intersection.
std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis);
/// The same without conditions and probability of conformity.
std::optional<AcceptanceDecision> decideVerdict(const Measurement& measurement, const SessionFit& fit,
                                                const Diagnosis* diagnosis);

/// The gap is real and unexplained beyond `mostUnexplained`: the verdict is open.
bool isUnexplained(const Diagnosis& diagnosis);

/// Model and readings disagree by more than noise that is larger than stated.
bool isMoreThanNoise(const Diagnosis& diagnosis);

}  // namespace alidade
