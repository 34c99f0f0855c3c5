#pragma once

#include <vector>

#include "core/series/shared_causes/shared_search.h"

namespace alidade {

/// The factor by which an instrument scatters more than stated in all its sessions. A few per cent are
/// undetectable in one session, but show in hundreds of readings and could be mistaken for effects. A session
/// may also scatter independently, for example after a knocked tripod; it then does not count for the others.
struct CommonNoise {
  std::string instrument;
  std::vector<std::size_t> sessions;
  double scale = 1, sigma = 0;  ///< factor of the stated noise, and its u
  bool isLarger = false;        ///< larger than stated by more than the tenth to which σ is known
  bool isOfOne = false;         ///< applies only to the one session in `sessions`
  double probability = 0;       ///< that the noise is larger; with `isOfOne`, that it is independent
};

/// The noise of each instrument, from the residuals that `set` leaves: one entry for all its sessions except
/// those that scatter independently, then one entry for each of these.
std::vector<CommonNoise> commonNoise(const std::vector<SessionSums>& sums,
                                     const std::vector<SessionOwners>& owners, const SharedSet& set);

/// χ² that the set and the session's explanation leave, at the stated σ.
double chiSquareLeft(const SessionSums& sums, std::size_t session, const SharedSet& set);

}  // namespace alidade
