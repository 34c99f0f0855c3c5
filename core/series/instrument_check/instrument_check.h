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
  double pValue;  ///< of an s as large by chance
  bool isWithin() const { return pValue >= levelOfTests; }
};

/// Are two s of one instrument? Question b): F = s₁²/s₂², two-sided at 95 %. NaN where one has no degrees of
/// freedom.
struct TwoSamples {
  std::string first, second;  ///< stations; an empty second: all others
  double directionP, verticalP;
};

struct CheckOptions {
  std::optional<double> sigmaDirection = {}, sigmaVertical = {};  ///< stated, of both faces once, arcsec
};

/// The field check of an instrument: every station by itself, and all pooled.
struct InstrumentCheck {
  std::vector<StationCheck> stations;
  CheckScatter direction, vertical;           ///< Σ r² and ν of all stations added
  PairMean collimation, index;                ///< of all stations (pooled_faces.h)
  std::optional<TwoCauses> lineOfSight = {};  ///< with the same collimation; absent: not stated
  std::optional<PairMean> tilt = {};          ///< of the trunnion axis; absent: not stated
  double collimationsDifferP = 1,
         indicesDifferP = 1;  ///< chance that stations differ as much by scatter alone
  std::optional<SigmaTest> directionTest, verticalTest;  ///< of the pooled s
  std::vector<TwoSamples> samples;  ///< two stations, or each of several against the others
};

InstrumentCheck checkInstrument(const std::vector<StationRounds>& stations, const CheckOptions& options = {});

}  // namespace alidade
