#pragma once

#include <optional>
#include <vector>

#include "core/series/instrument_check/station_check.h"

namespace alidade {

/// A number pooled from all stations. The cofactor of each station's fit sets its weight, the variance is
/// pooled within stations, and u is multiplied by √F if stations differ by more than their scatter.
struct Pooled {
  PairMean mean;
  double differP;  ///< probability that scatter alone causes such differences between stations; NaN: unknown
};

/// c and the offset of the line of sight, with their correlation.
struct PooledSight {
  Pooled collimation;
  std::optional<TwoCauses> lineOfSight;  ///< absent if no station states it
};

Pooled pooledIndex(const std::vector<StationCheck>& stations);

/// Pools only the stations that state every cause which any of them states: the collimation of the others
/// includes e_s/D and i sin e of their targets. If none states both, those with an offset of the line of
/// sight.
PooledSight pooledSight(const std::vector<StationCheck>& stations);

/// The mean weighted by 1/u²; u grows if stations differ by more than their u. Absent without a stated tilt.
std::optional<PairMean> pooledTilt(const std::vector<StationCheck>& stations);

}  // namespace alidade
