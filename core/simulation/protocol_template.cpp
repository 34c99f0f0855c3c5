#include "core/simulation/protocol.h"

#include <string>

#include "core/base/number_text.h"

namespace alidade {

namespace {

/// The angle as typed text, to a thousandth of an arcsecond.
std::string typedDegrees(Angle angle) {
  constexpr int decimals = 7;
  std::string text = fixedText(angle.degrees(), decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + "°";
}

std::vector<int> templateFaces(FacePlan faces, int round) {
  if (faces == FacePlan::BothAtEachPlace) return {1, 2};
  return {faces == FacePlan::Alternating && round % 2 == 0 ? 2 : 1};
}

}  // namespace

SightingProtocol templateOf(const Protocol& plan) {
  SightingProtocol protocol;
  protocol.name = plan.name;
  protocol.description = plan.description;
  protocol.readsSlider = plan.slider;
  for (int point = 1; point <= plan.points; ++point)
    protocol.places.push_back({.point = point, .slider = typedDegrees(plannedPlace(plan, point))});
  for (std::size_t i = 0; i < plan.axes.size(); ++i) {
    ProtocolPosition position{.axisDeg = plan.axes[i], .rounds = {}};
    if (plan.circleShift != Angle() && i > 0)
      position.circleTurn = typedDegrees(plan.circleShift * static_cast<double>(i));
    if (plan.faces != FacePlan::FaceOne) position.zeros.before = {1, 2};
    for (int round = 1; round <= plan.rounds; ++round)
      position.rounds.push_back({.isBack = round % 2 == 0, .faces = templateFaces(plan.faces, round)});
    protocol.positions.push_back(std::move(position));
  }
  return protocol;
}

SightingProtocol usualProtocol() {
  SightingProtocol protocol = templateOf(*protocolByName("paper"));
  protocol.name = protocol.description = "";
  for (ProtocolPlace& place : protocol.places) place.slider = "";
  protocol.isYielding = true;
  return protocol;
}

std::optional<SightingProtocol> templateNamed(std::string_view name) {
  const Protocol* protocol = protocolByName(name);
  return protocol ? std::optional(templateOf(*protocol)) : std::nullopt;
}

}  // namespace alidade
