#include "core/simulation/protocol.h"

#include <algorithm>

namespace alidade {

namespace {

std::vector<Protocol> makeProtocols() {
  using enum FacePlan;
  return {
      {.name = "paper", .description = "17 places, face 1, as published"},
      {.name = "paper-slider", .description = "as paper, with slider readings", .slider = true},
      {.name = "there-and-back", .description = "as paper, there and back", .rounds = 2},
      {.name = "two-face",
       .description = "17 places there and back, both faces",
       .rounds = 2,
       .faces = BothAtEachPlace},
      {.name = "full",
       .description = "as two-face, with slider readings",
       .rounds = 2,
       .faces = BothAtEachPlace,
       .slider = true},
      {.name = "shifted-circle",
       .description = "as full, the horizontal circle turned by 90° between the positions",
       .rounds = 2,
       .faces = BothAtEachPlace,
       .slider = true,
       .circleShift = Angle::fromDegrees(90)},
      {.name = "again", .description = "as paper, 0° measured again after 180°", .axes = {0, 180, 0}},
      {.name = "full-again",
       .description = "as full, 0° measured again after 180°",
       .rounds = 2,
       .faces = BothAtEachPlace,
       .slider = true,
       .axes = {0, 180, 0}},
  };
}

const std::vector<Protocol>& protocols() {
  static const std::vector<Protocol> all = makeProtocols();
  return all;
}

std::vector<int> facesOf(const Protocol& protocol, int round) {
  switch (protocol.faces) {
    case FacePlan::BothAtEachPlace:
      return {1, 2};
    case FacePlan::Alternating:
      return {round % 2 == 1 ? 1 : 2};
    case FacePlan::FaceOne:
      break;
  }
  return {1};
}

}  // namespace

std::vector<PlannedRow> plannedRows(const Protocol& protocol) {
  std::vector<PlannedRow> rows;
  for (int round = 1; round <= protocol.rounds; ++round)
    for (int i = 1; i <= protocol.points; ++i)
      for (const int face : facesOf(protocol, round))
        rows.push_back({round, round % 2 == 1 ? i : protocol.points + 1 - i, face});
  return rows;
}

Angle plannedPlace(const Protocol& protocol, int point) {
  return protocol.first + protocol.step * (point - 1);
}

std::span<const Protocol> namedProtocols() {
  return protocols();
}

const Protocol* protocolByName(std::string_view name) {
  const auto found = std::ranges::find(protocols(), name, &Protocol::name);
  return found == protocols().end() ? nullptr : &*found;
}

}  // namespace alidade
