#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/angle.h"
#include "core/series/instrument_check/face_causes.h"
#include "core/series/instrument_check/rounds.h"

namespace alidade {

// The full procedure of ISO 17123-3 at one station: n rounds to t targets, each in both faces. With x the
// mean of both faces of round j to target k,
//
//   directions x relative to the first target; d = x̄ₖ − xⱼₖ; r = d − d̄ⱼ; ν = (n − 1)(t − 1)
//   zenith angles r = x̄ₖ − xⱼₖ; ν = (n − 1) t
//   s = √(Σ r²/ν), of a direction or zenith angle observed once in both faces
//
// Half the difference of the faces is h = c/cos e + i tan e + e_s/(D cos e) on the horizontal circle and j on
// the vertical one. The signs are those of face 1 (core/effects). Every pair gives a collimation c = h cos e
// and an index j; their means are stated, with u = s/√N and N − 1 degrees of freedom, where s is their
// scatter. If c differs between targets, its u is from the t means of the targets. If a trunnion tilt or an
// offset of the line of sight is stated, the collimation is from the same fit (face_causes.h). Lengths in mm,
// angles in arcseconds.

/// A standard deviation from its sum of squares; `s` is NaN without degrees of freedom.
struct CheckScatter {
  double sumOfSquares = 0, degreesOfFreedom = 0;

  double s() const;
  void add(const CheckScatter& other);
};

/// Linear trend of values over the rounds, by least squares, and its significance.
struct RoundTrend {
  double perRound, u;
  double degreesOfFreedom;  ///< rounds − 2
  double pValue;            ///< two-sided probability that chance exceeds the slope
};

/// The results of one round.
struct RoundCourse {
  std::string name;
  double collimation, index;
  double orientation;  ///< mean of its directions minus that of all rounds; NaN if the circle was reset
};

/// The results of a target over all rounds.
struct TargetMean {
  std::string name;
  double elevationDeg, distanceM;  ///< the distance is 0 if unknown
  double collimation, index;
};

struct PairResidual {
  std::size_t round = 0, target = 0;
  double direction, vertical;
};

struct StationCheck {
  std::string station;
  CheckCircles circles = CheckCircles::Both;
  std::size_t targets = 0, rounds = 0;
  CheckScatter direction, vertical;  ///< without degrees of freedom if the circle was not read
  PairMean collimation = {};         ///< from the fit of the stated causes, else the mean
  PairMean index = {};
  FaceCauses causes = {};
  double nearestM = 0, farthestM = 0;    ///< 0: not known for all targets
  double lowestDeg = 0, highestDeg = 0;  ///< elevations
  bool isCircleReset = false;            ///< the circle turned by more than 180″ between rounds
  std::optional<RoundTrend> collimationSlope, indexSlope, orientationSlope;
  double targetsDifferP = 1;  ///< p-value of the test that c is the same for all targets; NaN: unknown
  std::vector<RoundCourse> course;
  std::vector<TargetMean> perTarget;
  std::vector<PairResidual> residuals;
  std::vector<LeftOutReadings> leftOut;
  std::string parted = {};  ///< sentence: why these rounds form a separate station; else empty

  std::size_t pairs() const { return targets * rounds; }
};

StationCheck checkStation(const StationRounds& station);

}  // namespace alidade
