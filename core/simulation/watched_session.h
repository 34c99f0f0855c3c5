#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/random_source.h"
#include "core/session/session.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth.h"

namespace alidade {

/// A session that grows sighting by sighting, in any order, under a known truth. Each sighting takes as long
/// as a row of the protocol, so that a drift has the same rate.
class WatchedSession {
 public:
  /// `protocol` and `truth` must outlive this object.
  WatchedSession(const Protocol& protocol, const Truth& truth, std::uint64_t seed);

  /// Sights a place at this axis. If the axis was turned, a new position begins, with its pointing zero.
  void sight(int axisDeg, int round, int point, int face);
  /// Sights the zero of the present position once more.
  void sightZero();

  const Session& session() const { return m_session; }
  /// The usable part of the session.
  std::optional<Measurement> measurement() const;
  std::size_t sightings() const { return m_taken; }  ///< number of sightings of places

 private:
  const Protocol& m_protocol;
  const Truth& m_truth;
  RandomSource m_random;
  Session m_session;
  std::size_t m_rows = 1, m_taken = 0;
  int m_round = 0, m_point = 0;
  Angle m_place;
  std::string m_slider;

  Angle noise(Angle sigma) { return sigma * m_random.normal(); }
  PerfectReadings perfect(int axisDeg) const;
  Moment moment(int round) const;
  ZeroSighting zero(int axisDeg);
};

}  // namespace alidade
