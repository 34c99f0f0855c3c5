#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/series/instrument_check/station_check.h"

namespace alidade {

/// Is s no larger than a stated σ? ISO 17123-3, question a): s ≤ σ √(χ²₀.₉₅(ν)/ν).
struct SigmaTest {
  double sigma;
  double limit;   ///< of s, at 95 %
  double pValue;  ///< probability that chance exceeds s
  bool isWithin() const { return pValue >= levelOfTests; }
};

/// Do two values of s belong to one instrument? Question b): F = s₁²/s₂², two-sided at 95 %. NaN if one has
/// no degrees of freedom.
struct TwoSamples {
  std::string first, second;  ///< stations; empty second: all others
  double directionP, verticalP;
};

struct CheckOptions {
  std::optional<double> sigmaDirection = {}, sigmaVertical = {};  ///< stated for the mean of both faces,
                                                                  ///< arcsec
};

/// The field check of an instrument: each station separately, and all pooled.
struct InstrumentCheck {
  std::vector<StationCheck> stations;
  CheckScatter direction, vertical;           ///< sums of Σ r² and ν over all stations
  PairMean collimation, index;                ///< of all stations (pooled_faces.h)
  std::optional<TwoCauses> lineOfSight = {};  ///< with the same collimation; absent: not stated
  std::optional<PairMean> tilt = {};          ///< of the trunnion axis; absent: not stated
  double collimationsDifferP = 1,
         indicesDifferP = 1;  ///< probability that scatter alone causes such differences between stations
  std::optional<SigmaTest> directionTest, verticalTest;  ///< of the pooled s
  std::vector<TwoSamples> samples;  ///< two stations, or each of several against all others
};

InstrumentCheck checkInstrument(const std::vector<StationRounds>& stations, const CheckOptions& options = {});

}  // namespace alidade
