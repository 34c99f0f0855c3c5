#include "core/connection/gsi_information.h"

#include <cstddef>

#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr std::size_t compensatorAt = 3, inputAt = 4, signAt = 6;

/// The word of that index up to its sign; empty: there is none.
std::string_view headOfWord(std::string_view block, int index) {
  const std::string wanted = std::to_string(index);
  for (std::size_t at = 0; at + signAt < block.size(); ++at) {
    const bool isStart = at == 0 || block[at - 1] == ' ' || block[at - 1] == '*';
    const char sign = block[at + signAt];
    if (isStart && block.substr(at, wanted.size()) == wanted && (sign == '+' || sign == '-'))
      return block.substr(at, signAt);
  }
  return {};
}

}  // namespace

GsiInformation gsiInformation(std::string_view block, int index) {
  GsiInformation information;
  const std::string_view head = headOfWord(block, index);
  if (head.empty()) return information;
  const char compensator = head[compensatorAt], input = head[inputAt];
  if (compensator == '0') information.isCompensated = false;
  if (compensator == '1' || compensator == '3') information.isCompensated = true;
  if (input == '2') information.isHorizontalCorrected = true;
  if (input == '3') information.isHorizontalCorrected = false;
  information.isKeyedIn = input == '1';
  information.isComputed = input == '4';
  return information;
}

std::string gsiCorrections(const GsiInformation& horizontal, const GsiInformation& vertical) {
  const auto isCompensated = vertical.isCompensated ? vertical.isCompensated : horizontal.isCompensated;
  if (!isCompensated || !horizontal.isHorizontalCorrected) return {};
  if (*isCompensated && *horizontal.isHorizontalCorrected)
    return "inclination standing_axis collimation tilting_axis";
  if (*isCompensated) return "inclination";
  return *horizontal.isHorizontalCorrected ? "collimation tilting_axis" : "none";
}

std::string gsiReservation(const GsiInformation& horizontal, const GsiInformation& vertical) {
  if (horizontal.isKeyedIn || vertical.isKeyedIn)
    return Phrase::of("The instrument says that an angle was keyed in, not measured.");
  if (horizontal.isComputed || vertical.isComputed)
    return Phrase::of(
        "The instrument says that an angle is the result of one of its functions, not of a circle.");
  return {};
}

}  // namespace alidade
