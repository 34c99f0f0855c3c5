#include "core/connection/gsi_information.h"

#include "core/base/phrase.h"

namespace alidade {

GsiInformation gsiInformation(const GsiWord& word) {
  GsiInformation information;
  if (word.compensator == '0') information.isCompensated = false;
  if (word.compensator == '1' || word.compensator == '3') information.isCompensated = true;
  if (word.input == '2') information.isHorizontalCorrected = true;
  if (word.input == '3') information.isHorizontalCorrected = false;
  information.isKeyedIn = word.input == '1';
  information.isComputed = word.input == '4';
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
