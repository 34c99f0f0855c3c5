#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/result/sighting_plan.h"
#include "core/session/measurement.h"

namespace alidade {

// Ranks the next sightings by their value per minute, and decides whether the sightings so far are enough.
//
// The hypotheses are: no cause, one effect of the catalogue, a form of an uncatalogued effect, a jump, a
// wrong zero, a gross error, larger noise. Once a cause other than a form or noise is certain, further causes
// are weighed in addition to it. At most one jump or wrong zero is assumed. Each hypothesis predicts the next
// reading by a normal distribution, given the readings so far and all unknowns. The worth of a sighting is Σ
// √(wᵢ wⱼ) (1 − BCᵢⱼ) over pairs of hypotheses, plus a tenth of −ln(U after/U before) of Δd. w are the
// probabilities, BC is the Bhattacharyya coefficient of the two predictions.
//
// The results stay valid however often they are looked at. The evidence against no cause is a Bayes factor
// with fixed prior widths, on readings without the part that the unknowns can absorb. If there is no cause
// and the stated σ are right, this factor is a nonnegative martingale and ever exceeds 1/α with a probability
// of at most α (Ville 1939). U depends on which readings were taken but not on their values, so stopping at a
// U leaves its coverage unchanged. The range of Δd for a verdict widens U by a normal mixture (Robbins 1970).

/// A hypothesis and its probability; `cause` is empty for no cause.
struct WeighedCause {
  std::string cause;
  double probability = 0;
};

/// The probability that one cause of `group` is present.
double probabilityOf(const std::vector<std::string>& group, const std::vector<WeighedCause>& causes);

/// Why no further sighting is needed.
enum class Enough { No, Named, VerdictCertain, WillNotHelp };

/// The state of a session after its last sighting.
struct SessionSoFar {
  Enough enough = Enough::No;
  double logEvidence = 0;        ///< ln of the Bayes factor against no cause
  double logEvidenceNeeded = 0;  ///< ln 1/α; with this evidence or more, some cause is evident
  /// All hypotheses, the most probable first, each weighed alone; the first also with one further cause.
  std::vector<WeighedCause> causes;
  /// The most probable cause that is neither a form nor noise, and the causes that no sighting of the plan
  /// separates from it, once this group is certain. Further causes are weighed only then.
  std::vector<std::string> certain;
  /// `certain`, once a second cause is named or only noise is left; or `formId`, an uncatalogued effect.
  std::vector<std::string> named;
  /// The hypotheses for a further cause in addition to the first of `certain`, the most probable first; an
  /// empty cause means no further one.
  std::vector<WeighedCause> further;
  std::vector<std::string> alsoNamed;         ///< a second cause, as `named`, certain given the first
  bool isAlone = true;                        ///< the Bayes factor for a further cause is at most 0.6
  std::optional<double> intersection, sigma;  ///< Δd and its σ with every effect, mm
  double halfWidth = 0;                       ///< half the range that contains Δd at all times, mm
  bool isWithin = false;                      ///< whether |intersection| is within the tolerance
  std::vector<NextSighting> ranked;           ///< the most valuable per minute first
};

/// Whether no further sighting is needed. Always false before both positions are read: Δd needs both.
inline bool isEnough(const SessionSoFar& state) {
  return state.enough != Enough::No && state.intersection.has_value();
}

/// Returns the state of a session with at least one sighting. Absent if its readings determine nothing. Jumps
/// and gross errors are sought among the sightings so far. If there is no cause, the probability of ever
/// naming one is at most α = 1 %. A named group has a probability of at least 95 %. The evidence for a
/// further cause has no such α, since the prior is then centred at the estimate of the first cause. Without
/// `ranks` no sighting is ranked, which is faster, and `enough` does not consider whether a further sighting
/// is worth its minutes.
std::optional<SessionSoFar> sessionSoFar(const Measurement& measurement, const SightingPlan& plan,
                                         bool ranks = true);

}  // namespace alidade
