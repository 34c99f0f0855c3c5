#pragma once

#include <string>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "readings", "model effects", "known radius", "pointing zeros", "distance".
std::string textOf(UncertaintySource source);

/// Its source: "readings", "plane_warp", "what else may explain the readings".
std::string textOf(const UncertaintyShare& share);
/// Where its size comes from: "scatter", "stated", "default" of the catalogue, "known", "diagnosis".
std::string textOf(UncertaintyShare::From from);
/// "A" or "B".
std::string textOf(UncertaintyShare::Type type);
/// 1σ of an effect's numbers, one where they are alike: "30", "10, 12"; empty of another source.
std::string numbersText(const UncertaintyShare& share);
/// The same with their unit: "30 arcsec", "10, 12 arcsec".
std::string sizesText(const UncertaintyShare& share);

}  // namespace alidade
