#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

// The verdict of an acceptance, from the fit and the diagnosis with fixed thresholds.
//
// 1. Both results must agree: Δd ± U of the session's own model, and the measured Δd.
// 2. The measured Δd must satisfy the guard band (`decide`): accept only if |Δd| + U ≤ T, reject only if
//    |Δd| − U > T. It must also keep the risk on either side of the tolerance small, with the coverage c:
//
//      accept:  P(Δd > T) ≤ (1 − c)/2 and P(Δd < −T) ≤ (1 − c)/2,
//      reject:  P(Δd ≤ T) ≤ (1 − c)/2 or P(Δd ≥ −T) ≤ (1 − c)/2.
//
//    For a single explanation Δd ± kσ with P(t ≤ k) = (1 + c)/2 these conditions equal the guard band: for Δd
//    + kσ = T, P(Δd > T) = (1 − c)/2. For several distant explanations they are stricter.
// 3. P is that of the averaged explanations (`IntersectionEstimate`), each with the further standard
//    uncertainty of unexplained misclosures (`Unexplained::sigma`). A misclosure contributes in proportion to
//    the probability that a further cause is behind it.
// 4. The verdict is undecided if the gap is real and unexplained with a probability above `mostUnexplained`.
// 5. An undetectable effect of the catalogue is in U and in the probability, at its plausible size. An
//    undetectable jump is a condition of the verdict if its influence on Δd, added to the standard
//    uncertainty, changes the verdict. The probability of conformity includes the jump, with its prior odds.

/// Least coverage of U for a verdict: a guard band of lower coverage gives no protection.
constexpr double leastCoverageOfVerdict = 0.9;

struct AcceptanceDecision {
  /// The reason why the verdict is neither accept nor reject.
  enum class Obstacle {
    None,
    Uncertainty,    ///< U is too large in both results
    Lengths,        ///< a length is in doubt, so the verdict is withheld
    Coverage,       ///< the coverage of U is too low for a verdict
    Contradiction,  ///< the results of fit only and measured differ
    AcrossUnknown,  ///< the tolerance applies to the distance from the axis, and a part of it was not
                    ///< measured
    Unexplained,    ///< the gap is real, and almost certainly no effect of the catalogue explains it
  };

  Verdict verdict = Verdict::Undecided;
  /// From Δd ± U of the session's own model, which determines only the part Δd of the distance from the axis.
  Verdict asModelled = Verdict::Undecided;
  /// From the measured Δd (2 and 3 above); absent without a diagnosis.
  std::optional<Verdict> asFound = {};
  Obstacle obstacle = Obstacle::Uncertainty;
  /// Whether both results, fit only and measured, must be shown with the verdict.
  bool showsBoth = false;
  /// Probability, 0…1, that the measurand is within the tolerance: from the measured Δd, or without a
  /// diagnosis from the fit only (`conformanceOf`). Undetectable jumps are included. Absent if the verdict is
  /// withheld, the gap is unexplained, U is infinite, or a part of the measurand is not measured.
  std::optional<double> conformance = {};
  /// Indices into `Diagnosis::undetectableJumps`: the jumps whose influence on Δd, added to the standard
  /// uncertainty, changes the verdict from accept or reject.
  std::vector<std::size_t> conditions = {};

  bool operator==(const AcceptanceDecision&) const = default;
};

/// `fit` and `diagnosis` belong to `measurement`; a null `diagnosis` means that none was made. Absent if the
/// fit has no verdict: without a tolerance or an intersection.
std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis);
/// Like `decideAcceptance`, but without `conditions` and `conformance`.
std::optional<AcceptanceDecision> decideVerdict(const Measurement& measurement, const SessionFit& fit,
                                                const Diagnosis* diagnosis);

/// The distance from the axis, if the tolerance applies to it and both its parts were measured; else null,
/// and Δd is judged.
const MeasuredLength* judgedDistance(const Measurement& measurement, const MeasuredIntersection& measured);

/// Whether the probability of an unexplained gap exceeds `mostUnexplained`, so that the verdict is undecided.
bool isUnexplained(const Diagnosis& diagnosis);

/// Whether the session's model leaves a gap: residuals beyond the noise, or positions that do not close.
bool hasGap(const Diagnosis& diagnosis);

/// Whether the gap exceeds what larger noise alone explains.
bool isMoreThanNoise(const Diagnosis& diagnosis);

}  // namespace alidade
