#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/random_source.h"
#include "core/base/result.h"
#include "core/session/session.h"
#include "core/simulation/sealed_truth.h"
#include "core/simulation/truth.h"

namespace alidade {

// A blind trial: a session of a truth that is drawn and sealed, to be diagnosed, and scored when the seal is
// opened. The kind is drawn first: nothing, one effect of the catalogue, misread values, a knocked tripod,
// the other vertical angle relation, more noise than stated, two effects at once, a disturbance of no
// catalogue. An effect is as large as makes it visible by a length that is uniform in a range of σ, but no
// larger than a few of its plausible sizes.

struct BlindTrialOptions {
  std::string protocol;      ///< by name; empty: drawn from those known by name
  double leastVisible = 6;   ///< σ of the readings
  double mostVisible = 25;   ///< σ of the readings
  double mostPlausible = 6;  ///< plausible sizes
  std::vector<std::string> kinds =
      {};  ///< of `trialKinds()`, one as likely as the other; empty: all, as often as there
};

/// A kind of truth and how often it is drawn.
struct TrialKind {
  std::string name;  ///< an id of the catalogue, "none", "gross_error", "two_causes", "unknown", …
  double weight = 0;
};

/// Every kind that can be drawn; the weights add up to 1.
const std::vector<TrialKind>& trialKinds();

struct BlindTrial {
  Session session;  ///< its title does not give the truth away
  Truth truth;
  SealedTruth seal;
};

/// The same seed and options give the same trial. Fails where the protocol or a kind is not known.
Result<BlindTrial> drawBlindTrial(const BlindTrialOptions& options, std::uint64_t seed);

/// Puts a disturbance of no catalogue into the truth, of size 1 (mm or arcsec), its place and form drawn.
void putForeign(Truth& truth, RandomSource& random);
/// Gives it another size, mm or arcsec.
void setForeignSize(Truth& truth, double size);

}  // namespace alidade
