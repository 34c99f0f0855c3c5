#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/observation/observe.h"
#include "core/session/session.h"
#include "core/simulation/protocol.h"
#include "core/simulation/truth.h"

namespace alidade {

// Simulates a theodolite that reads a guideway. The errors of both are known (the truth); a plan (the
// protocol) states the readings. Readings follow from the forward model (observe.h), with white normal noise
// of the stated σ, and are rounded to the truth's step. The pointing zero of each position is sighted in face
// 1 just before its rows or, if the truth requires it, in both faces just before and just after them.

/// Circle readings in one face, neither rounded nor wrapped.
struct CircleReadings {
  Angle horizontal, vertical;
};

/// The moment at which a row is taken.
struct Moment {
  double elapsed = 0;         ///< elapsed share of the session's rows, 0…1
  bool afterJump = false;     ///< after the truth's jump
  bool wayBack = false;       ///< in an even round
  bool isSetUpAgain = false;  ///< in a position after the first
  int round = 1;
};

/// The readings of a truth without noise and gross errors, one position at a time.
class PerfectReadings {
 public:
  /// `horizontalZero`: the circle's reading in the direction of the pointing zero.
  PerfectReadings(const Truth& truth, int axisDeg, Angle horizontalZero);

  /// Readings of the pointing zero.
  CircleReadings zero(int face = 1, const Moment& moment = {}) const;
  /// Readings of the target with the slider at coordinate `s` (equal to φ at 0°, to −φ at 180°).
  CircleReadings target(Angle s, int face, const Moment& moment) const;
  Angle slider(Angle s, const Moment& moment = {}) const;

 private:
  Pointing pointing(int face, const Moment& moment) const;
  /// Arguments of the user's own effects; absent without any. `s`: absent for a pointing zero.
  std::optional<OwnPlace> ownPlace(std::optional<Angle> s, int face, const Moment& moment) const;
  ArcPose<double> poseAt(Angle s) const;
  SpacePoint<double> inRoom(const SpacePoint<double>& target) const;
  double arcAngle(Angle s) const;
  CircleReadings onCircles(const Direction<double>& direction, int face) const;
  /// The circle readings in a direction, with the truth's foreign effect.
  CircleReadings disturbed(Direction<double> direction, int face, const Moment& moment) const;

  const Truth& m_truth;
  ErrorTerms<double> m_errors;
  int m_axisDeg;
  Angle m_horizontalZero;
  std::shared_ptr<const OwnModel> m_own;  ///< null: none
};

/// The session of a truth, by a protocol, with the noise of `seed`. The same seed gives the same places and
/// noise for any truth, with or without slider readings. Fails, with the row, if a gross error names a row
/// that the protocol lacks, or if a target cannot be sighted. Example: samples/programs/simulate.cpp.
Result<Session> simulate(const Protocol& protocol, const Truth& truth, std::uint64_t seed);

/// The session of `simulate` without noise and without rounding to the truth's step.
Result<Session> simulateWithoutNoise(const Protocol& protocol, const Truth& truth, std::uint64_t seed);

}  // namespace alidade
