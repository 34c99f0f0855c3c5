#pragma once

#include <string>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "readings", "model effects", "known radius", "pointing zeros", "distance".
std::string textOf(UncertaintySource source);

/// The origin: "readings", "plane_warp", "what else may explain the readings".
std::string textOf(const UncertaintyShare& share);
/// The source of the size of a share: "scatter", "stated", "default" of the catalogue, "known", "diagnosis".
std::string textOf(UncertaintyShare::From from);
/// "A" or "B".
std::string textOf(UncertaintyShare::Type type);
/// 1σ of an effect's numbers, only once if all are equal: "30", "10, 12"; empty for other origins.
std::string numbersText(const UncertaintyShare& share);
/// The same with their unit: "30 arcsec", "10, 12 arcsec".
std::string sizesText(const UncertaintyShare& share);
/// The same for people: "30″", "10, 12″".
std::string sizesWithSign(const UncertaintyShare& share);

}  // namespace alidade
