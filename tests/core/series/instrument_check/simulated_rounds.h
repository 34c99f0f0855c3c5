#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/random_source.h"
#include "core/series/instrument_check/check_readings.h"

namespace alidade::test {

struct Target {
  double azimuthDeg, elevationDeg, distanceM = 0;
};

/// The readings of an instrument with known errors, by the formulas of a textbook and without code of the
/// program.
struct SimulatedInstrument {
  double collimation = 0, tilt = 0, index = 0;  ///< arcsec, for face 1
  double eccentricityMm = 0;                    ///< of the line of sight
  double noise = 0;                             ///< of one reading, arcsec
  double circleStepDeg = 0;                     ///< by which the circle is turned between rounds
  double driftPerRound = 0;                     ///< of the orientation, arcsec
};

/// Rounds from a station: all targets in face 1, and back in face 2.
inline CheckReadings simulatedRounds(const SimulatedInstrument& instrument,
                                     const std::vector<Target>& targets, int rounds, std::uint64_t seed) {
  constexpr double perDegree = 3600;
  RandomSource random(seed);
  CheckReadings readings;
  readings.stations = {"S"};
  for (std::size_t k = 0; k < targets.size(); ++k)
    readings.targets.push_back(std::string(1, static_cast<char>('A' + k)));
  const auto read = [&](int round, std::size_t k, int face) {
    const Target& target = targets[k];
    const double e = target.elevationDeg * 0.017453292519943295, side = face == 1 ? 1 : -1;
    double off = instrument.collimation / std::cos(e) + instrument.tilt * std::tan(e);
    if (target.distanceM > 0)
      off += instrument.eccentricityMm / (target.distanceM * 1000 * std::cos(e)) * 206264.80624709636;
    const double alpha =
        target.azimuthDeg + instrument.circleStepDeg * round + (face == 1 ? 0 : 180) +
        (side * off + instrument.driftPerRound * round + instrument.noise * random.normal()) / perDegree;
    const double zenith = 90 - target.elevationDeg;
    const double beta = (face == 1 ? zenith : 360 - zenith) +
                        (instrument.index + instrument.noise * random.normal()) / perDegree;
    FaceReading reading;
    reading.target = k;
    reading.face = face;
    reading.horizontal = wrapped(Angle::fromDegrees(alpha), Angle::fromDegrees(180));
    reading.vertical = Angle::fromDegrees(beta);
    reading.distanceM = target.distanceM;
    readings.readings.push_back(reading);
  };
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < targets.size(); ++k) read(round, k, 1);
    for (std::size_t k = targets.size(); k-- > 0;) read(round, k, 2);
  }
  return readings;
}

}  // namespace alidade::test
