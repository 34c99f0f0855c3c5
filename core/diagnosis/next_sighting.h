#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/measurement.h"

namespace alidade {

// The sighting that tells most for its minutes, and whether the sightings so far are enough.
//
// What may be the case: nothing, one effect of the catalogue, a form of no catalogue, a jump, a wrong zero, a
// misread value, larger noise. Each predicts the next reading by a normal distribution, given the readings so
// far and all unknowns. A sighting is worth Σ √(wᵢ wⱼ) (1 − BCᵢⱼ) over pairs of these, plus −ln(U after/U
// before) of Δd. w are the probabilities, BC is the Bhattacharyya coefficient of the two predictions.
//
// The statements may be looked at after every reading. The evidence against nothing is a Bayes factor with
// fixed prior widths, on readings without the part that the unknowns can take. It is a nonnegative martingale
// if nothing is the case and the stated σ are right, so it ever exceeds 1/α with a probability of at most α
// (Ville 1939). U depends on which readings were taken but not on their values, so stopping at a U leaves its
// coverage unchanged. The range of Δd for a verdict widens U by a normal mixture (Robbins 1970).

/// One of what may be the case; no cause for nothing.
struct WeighedCause {
  std::string cause;
  double probability = 0;
};

/// Why no further sighting is needed.
enum class Enough { No, Named, VerdictCertain, WillNotHelp };

/// The state of a session after its last sighting.
struct SessionSoFar {
  Enough enough = Enough::No;
  double logEvidence = 0;            ///< ln E against nothing
  double logEvidenceNeeded = 0;      ///< ln 1/α: from here on there is something
  std::vector<WeighedCause> causes;  ///< the most probable first, nothing included
  /// The most probable cause and those that no sighting of the plan separates from it, if named. `formId`
  /// stands for an effect of no catalogue.
  std::vector<std::string> named;
  std::optional<double> intersection, sigma;  ///< of Δd with every effect possible, mm
  double halfWidth = 0;                       ///< of the range of Δd that holds at all times together, mm
  bool isWithin = false;                      ///< the tolerance, if the verdict is certain
  std::vector<NextSighting> ranked;           ///< the most worth per minute first
};

/// Is no further sighting needed? Not before both positions are read, whatever is named: they make Δd.
inline bool isEnough(const SessionSoFar& state) {
  return state.enough != Enough::No && state.intersection.has_value();
}

/// The state of a session with at least one sighting. Absent if its readings determine nothing. Jumps and
/// gross errors are sought among the sightings so far. The probability of ever naming a cause where there is
/// nothing is α = 1 %, that of the named group at least 95 %. Unless it `ranks`, no sighting is ranked, which
/// is faster.
std::optional<SessionSoFar> sessionSoFar(const Measurement& measurement, const SightingPlan& plan,
                                         bool ranks = true);

}  // namespace alidade
