#pragma once

#include <optional>

#include "core/adjustment/result/session_fit.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// A guard band of a lower coverage guards against nothing.
constexpr double leastCoverageOfVerdict = 0.9;

/// The verdict of an acceptance in the light of the diagnosis: accept or reject only where the session's own
/// model and what was found beside it both say so, and the two positions agree on what they must.
struct AcceptanceDecision {
  /// What stands in the way of accept or reject.
  enum class Obstacle {
    None,
    Uncertainty,    ///< U, on both accounts
    Lengths,        ///< in doubt, so the verdict is withheld
    Coverage,       ///< U is stated at a coverage too low for a verdict
    Contradiction,  ///< the two accounts do not say the same
    Misclosure,     ///< the positions disagree where they must not, and nothing found accounts for it
  };

  Verdict verdict = Verdict::Undecided;
  Verdict asModelled = Verdict::Undecided;  ///< by Δd ± U of the session's own model
  std::optional<Verdict> asFound = {};      ///< by `Diagnosis::measured`; absent without a diagnosis
  Obstacle obstacle = Obstacle::Uncertainty;
  /// There are two accounts, that of the fit alone and that of the measurement: both belong beside the
  /// verdict.
  bool showsBoth = false;
  /// Probability that |Δd| is within the tolerance, 0…1, by what is believed of Δd as measured, or without a
  /// diagnosis by the fit (JCGM 106:2012, 7.4). Absent where the verdict is withheld, a closure fails, or U
  /// has no end.
  std::optional<double> conformance = {};

  bool operator==(const AcceptanceDecision&) const = default;
};

/// `fit` and `diagnosis` are of `measurement`; null: there was no diagnosis. Absent where the fit has no
/// verdict: without a tolerance or an intersection.
std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis);

/// The greatest probability, 0…1, that a guarded verdict (`decide`) at this tolerance (mm, > 0) is wrong:
/// that |Δd| is beyond it though accepted at its very edge, |Δd| + U = tolerance, or within it though
/// rejected at |Δd| − U = tolerance. What is believed of Δd is as wide and as skew there as in `estimate`; (1
/// − coverage)/2 where it is symmetric and U far below the tolerance. Absent where U has no end.
///
/// Source: JCGM 106:2012, 8.3, decision rules based on guard bands; ILAC-G8:09/2019, 4.2, w = U.
std::optional<double> greatestRisk(const IntersectionEstimate& estimate, double tolerance);

/// Model and readings disagree by more than noise that is larger than stated.
bool isMoreThanNoise(const Diagnosis& diagnosis);

}  // namespace alidade
