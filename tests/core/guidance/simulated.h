#pragma once

#include <cstdint>
#include <string>

#include "core/session/protocol_progress.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade::test {

/// A plan of readings different from the named ones.
inline Protocol plan(int points, double first, double step, int rounds, FacePlan faces = FacePlan::FaceOne) {
  return {.name = "own",
          .description = "",
          .points = points,
          .first = Angle::fromDegrees(first),
          .step = Angle::fromDegrees(step),
          .rounds = rounds,
          .faces = faces};
}

/// A guideway without effects, set up off the middle, with Δd = 0.8 mm.
inline Truth truth(VerticalCircle circle = VerticalCircle::Zenith) {
  Truth truth;
  truth.centreX = 1.2;
  truth.axisHeight = -0.9;
  truth.intersection = 0.8;
  truth.radius = 400.1;
  truth.verticalCircle = circle;
  truth.verticalZero = Angle::fromDegrees(circle == VerticalCircle::Zenith ? 90 : 0);
  return truth;
}

/// The readings of `simulate`: zeros in face 1 alone.
inline SightingProtocol asSimulated(const Protocol& plan) {
  SightingProtocol protocol = templateOf(plan);
  for (ProtocolPosition& position : protocol.positions) position.zeros.before = {1};
  return protocol;
}

/// A session cut after its first rows, in the order taken, before later positions have readings.
inline Session cut(Session session, std::size_t position, std::size_t rows) {
  session.positions[position].readings.resize(rows);
  for (std::size_t later = position + 1; later < session.positions.size(); ++later) {
    session.positions[later].readings.clear();
    session.positions[later].zero = {};
  }
  return session;
}

/// Returns the session without the rounds after number `rounds`.
inline Session firstRounds(Session session, int rounds) {
  for (Position& position : session.positions)
    std::erase_if(position.readings,
                  [&](const Reading& row) { return !row.round.empty() && std::stoi(row.round) > rounds; });
  return session;
}

}  // namespace alidade::test
