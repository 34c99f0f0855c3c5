#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/session/session.h"
#include "core/simulation/sealed_truth.h"
#include "core/simulation/truth.h"

namespace alidade {

// A blind trial: a simulated session with a drawn and sealed truth, to be diagnosed, and scored when the seal
// is opened. The kind is drawn first: none, one catalogued effect, misread values, a knocked tripod, the
// other vertical angle relation, more noise than stated, two effects at once, an uncatalogued disturbance.
// The size of an effect is chosen for a visible length that is uniform between two limits in σ. The size
// itself is at most a few plausible sizes.

struct BlindTrialOptions {
  std::string protocol;      ///< name of the protocol; empty: drawn from the named protocols
  double leastVisible = 6;   ///< smallest visible length of an effect, σ of the readings
  double mostVisible = 25;   ///< largest visible length of an effect, σ of the readings
  double mostPlausible = 6;  ///< largest size of an effect, plausible sizes
  std::vector<std::string> kinds =
      {};  ///< of `trialKinds()` and ids of `own`, with equal probability; empty: all, with their weights
  /// Effects of the user's own, drawn as often as one of the catalogue. The session states all of them.
  std::shared_ptr<const OwnEffects> own = {};
};

/// A kind of truth and its frequency.
struct TrialKind {
  std::string name;  ///< an id of the catalogue, "none", "gross_error", "two_causes", "unknown", …
  double weight = 0;
};

/// Every kind that can be drawn without the user's own effects; the weights add up to 1.
const std::vector<TrialKind>& trialKinds();

struct BlindTrial {
  Session session;  ///< its title does not reveal the truth
  Truth truth;
  SealedTruth seal;
};

/// The same seed and options give the same trial. Fails if the protocol or a kind is unknown.
Result<BlindTrial> drawBlindTrial(const BlindTrialOptions& options, std::uint64_t seed);

/// Adds an uncatalogued disturbance to the truth, of size 1 (mm or arcsec), with drawn place and form.
void putForeign(Truth& truth, RandomSource& random);
/// Sets the size of the uncatalogued disturbance, mm or arcsec.
void setForeignSize(Truth& truth, double size);

}  // namespace alidade
