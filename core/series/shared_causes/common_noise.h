#pragma once

#include <vector>

#include "core/series/shared_causes/shared_search.h"

namespace alidade {

/// How much more than stated an instrument scatters in all its sessions: a few percent show in hundreds of
/// readings that one session cannot show, and would pass for effects. A session may scatter by itself, a
/// stand that was knocked say, and says nothing of the others then.
struct CommonNoise {
  std::string instrument;
  std::vector<std::size_t> sessions;
  double scale = 1, sigma = 0;  ///< of the stated noise
  bool isLarger = false;        ///< by more than the tenth to which the stated σ holds
  bool isOfOne = false;         ///< of the only session in `sessions`, by itself
  double probability = 0;       ///< of that
};

/// Of each instrument, from what `set` leaves of its sessions: all but those that scatter by themselves, then
/// each of these.
std::vector<CommonNoise> commonNoise(const std::vector<SessionSums>& sums,
                                     const std::vector<SessionOwners>& owners, const SharedSet& set);

/// χ² of what the set and a session's account leave of it, stated σ.
double chiSquareLeft(const SessionSums& sums, std::size_t session, const SharedSet& set);

}  // namespace alidade
