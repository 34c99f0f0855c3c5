#pragma once

namespace alidade {

/// The conventions of the diagnosis: limits that are neither results nor priors, each with its reason.
struct DiagnosisThresholds {
  /// Probability from which a statement counts as certain: a cause beside a pattern is named, larger noise is
  /// taken as known, advice that leaves one cause needs no combination. One such statement in twenty is
  /// wrong, as with the usual U.
  double certain = 0.95;
  /// Of two sets of causes with odds this close (natural logarithm; odds of 7), the one with fewer causes is
  /// reported.
  double nearlyAsGood = 2;
  /// Traces that differ by this many σ are confused in 7 % of the cases. If they differ by less, they are not
  /// reliably separated.
  double hardlyDifferent = 3.0;
  /// Traces that differ by this many σ are confused in 2 % of the cases. If they differ by more, they are
  /// separated, provided that the readings agree.
  double clearlyDifferent = 4.2;
  /// Explanations with a smaller probability are not averaged into Δd: each needs a fit of its own.
  double leastAveraged = 0.01;
  /// Share of a plausible or known size in the variance of an estimate from which the readings determine
  /// nothing: what is left for them has more than four times that size as its uncertainty.
  double ofPriorOnly = 0.95;
  /// Effects whose plausible size or known uncertainty changes Δd by less, mm, are not reported: no tolerance
  /// of a guideway is that small.
  double negligibleInfluence = 1e-3;
  /// A larger probability of an unexplained gap leaves the verdict open. In 1000 simulated sessions, half of
  /// them with an uncatalogued effect, 508 had the verdict `NotInCatalogue`; 492 of these exceed the limit.
  /// The other 16 are unclear or depend on one reading; their U covers both cases.
  double mostUnexplained = 0.95;
};

inline constexpr DiagnosisThresholds thresholds;

}  // namespace alidade
