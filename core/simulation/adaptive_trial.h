#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/protocol.h"

namespace alidade {

// Blind trials of the choice of the next sighting. The same drawn truth is read twice until a cause is named:
// in the order of its protocol, and by the most informative sightings.

struct AdaptiveTrialOptions {
  std::size_t count = 100;         ///< truths with one cause
  std::size_t two = 0;             ///< truths with two causes
  std::size_t unknown = 0;         ///< truths with an uncatalogued effect
  std::size_t clean = 0;           ///< truths without a cause, watched sighting by sighting to the end
  bool readsCleanInOrder = false;  ///< also reads the truths without a cause in the protocol's order
  unsigned threads = 0;            ///< 0: as many as the machine has; the result is the same for any number
  std::function<void(std::size_t)> progress = {};
};

/// One session, read until its readings are enough, at most to the length of the protocol.
struct WatchedRun {
  /// U of Δd after one of the sightings, including every effect at its plausible size.
  struct Look {
    std::size_t sightings = 0;
    double minutes = 0;
    double expanded = 0;  ///< mm
  };

  /// Ids of the causes as in `SessionSoFar`, named at the end, whether the readings are enough or not. In a
  /// session watched to its end, named at any time.
  std::vector<std::string> named, alsoNamed;
  /// Every true cause, or a look-alike of it, is named, and nothing else. A form must be named for an
  /// uncatalogued effect. A faint effect may be missed.
  bool isRight = false;
  bool isWrong = false;       ///< a cause is named that the truth lacks
  std::size_t sightings = 0;  ///< of places and closing zeros
  double minutes = 0;
  double most = 0;               ///< the largest natural log of the evidence against no cause
  std::vector<Look> looks = {};  ///< from the first with both positions
};

/// The same truth read in the protocol's order, and by the most informative sightings.
struct WatchedRuns {
  WatchedRun ofProtocol = {}, byWorth = {};
};

struct AdaptiveTrial : WatchedRuns {
  SealedTruth truth;
  bool isRightInFull = false;  ///< the diagnosis of the whole protocol is right
  std::size_t rows = 0;        ///< of the whole protocol
};

struct AdaptiveTrials {
  /// Truths with one cause, then those with two, then those with an uncatalogued effect.
  std::vector<AdaptiveTrial> withCause;
  std::vector<WatchedRuns> clean;
};

/// Trial i has the seed `seed` + i. Fails if the protocol turns its circle or shows none of the truths.
Result<AdaptiveTrials> adaptiveTrials(const AdaptiveTrialOptions& options, const Protocol& protocol,
                                      std::uint64_t seed);

}  // namespace alidade
