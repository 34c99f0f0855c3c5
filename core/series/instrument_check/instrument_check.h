#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/series/instrument_check/station_check.h"

namespace alidade {

/// Test of s against a stated σ. ISO 17123-3, question a): s ≤ σ √(χ²₀.₉₅(ν)/ν).
struct SigmaTest {
  double sigma;
  double limit;   ///< of s, at 95 %
  double pValue;  ///< probability that chance exceeds s
  bool isWithin() const { return pValue >= levelOfTests; }
};

/// Test whether two values of s differ. ISO 17123-3, question b): F = s₁²/s₂², two-sided at 95 %. A
/// probability is NaN if one of the two values has no degrees of freedom.
struct TwoSamples {
  std::string first, second;  ///< stations; `second` is empty for all others
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
  std::optional<TwoCauses> lineOfSight = {};  ///< from the same fit as `collimation`; absent: not stated
  std::optional<PairMean> tilt = {};          ///< of the trunnion axis; absent: not stated
  double collimationsDifferP = 1,
         indicesDifferP = 1;  ///< probability that scatter alone causes such differences between stations
  std::optional<SigmaTest> directionTest, verticalTest;  ///< of the pooled s
  std::vector<TwoSamples> samples;  ///< of the two stations, or of each station against all others
};

InstrumentCheck checkInstrument(const std::vector<StationRounds>& stations, const CheckOptions& options = {});

/// Checks the readings station by station. If a figure is implausible (`implausibility`), fails and names the
/// lines: a wrong figure is worse than none.
Result<InstrumentCheck> checkReadings(const CheckReadings& readings, const CheckOptions& options = {});

}  // namespace alidade
