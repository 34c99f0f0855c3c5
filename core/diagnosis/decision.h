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
    AcrossUnknown,  ///< the tolerance is of the distance from the axis, of which a part was not measured
    Misclosure,     ///< the positions disagree where they must not, and nothing found accounts for it
  };

  Verdict verdict = Verdict::Undecided;
  /// By Δd ± U of the session's own model, which knows no more of a distance from the axis.
  Verdict asModelled = Verdict::Undecided;
  std::optional<Verdict> asFound = {};  ///< by `Diagnosis::measured`; absent without a diagnosis
  Obstacle obstacle = Obstacle::Uncertainty;
  /// There are two accounts, that of the fit alone and that of the measurement: both belong beside the
  /// verdict.
  bool showsBoth = false;
  /// Probability that the measurand is within the tolerance, 0…1, by what is believed of it as measured, or
  /// of Δd without a diagnosis by the fit (`conformanceOf`). Absent where the verdict is withheld, a closure
  /// fails, U has no end, or a part was not measured.
  std::optional<double> conformance = {};

  bool operator==(const AcceptanceDecision&) const = default;
};

/// `fit` and `diagnosis` are of `measurement`; null: there was no diagnosis. Absent where the fit has no
/// verdict: without a tolerance or an intersection.
std::optional<AcceptanceDecision> decideAcceptance(const Measurement& measurement, const SessionFit& fit,
                                                   const Diagnosis* diagnosis);

/// Model and readings disagree by more than noise that is larger than stated.
bool isMoreThanNoise(const Diagnosis& diagnosis);

}  // namespace alidade
