#pragma once

#include <optional>
#include <vector>

#include "core/series/instrument_check/station_check.h"

namespace alidade {

/// A number of all stations together. Each station has a weight by the cofactor of its own fit, the variance
/// is the pooled one within stations, and u grows by √F where stations differ by more than that.
struct Pooled {
  PairMean mean;
  double differP;  ///< chance that stations differ as much by their scatter alone; NaN: not known
};

/// Of c and the offset of the line of sight, with their correlation.
struct PooledSight {
  Pooled collimation;
  std::optional<TwoCauses> lineOfSight;  ///< absent where no station states it
};

Pooled pooledIndex(const std::vector<StationCheck>& stations);

/// Of the stations that state an offset of the line of sight, where one does: the collimation of the others
/// holds e/D of their targets.
PooledSight pooledSight(const std::vector<StationCheck>& stations);

/// The mean weighted by 1/u², u growing where the stations differ by more; absent: no station states a tilt.
std::optional<PairMean> pooledTilt(const std::vector<StationCheck>& stations);

}  // namespace alidade
