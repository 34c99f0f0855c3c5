#pragma once

#include <string>

#include "core/adjustment/result/intersection.h"
#include "core/diagnosis/result/diagnosis.h"

namespace alidade {

/// "readings", "model effects", "plausible sizes", "known radius", "pointing zeros" or "distance".
std::string textOf(UncertaintySource source);

/// The origin of a share: its source, "readings"; an effect, "plane_warp"; or "other possible explanations".
std::string textOf(const UncertaintyShare& share);
/// What the size of a share is based on: "scatter", "stated", "default", "known" or "diagnosis".
std::string textOf(UncertaintyShare::From from);
/// "A" or "B".
std::string textOf(UncertaintyShare::Type type);
/// 1σ of each number of an effect, equal neighbours once: "30", "10, 12"; empty if the share is no effect's.
std::string numbersText(const UncertaintyShare& share);
/// `numbersText` with the unit of the catalogue: "30 arcsec", "10, 12 arcsec".
std::string sizesText(const UncertaintyShare& share);
/// `numbersText` with the sign of the unit: "30″", "10, 12″".
std::string sizesWithSign(const UncertaintyShare& share);

/// Names what U includes beyond the fit: "averaged over the indistinguishable causes"; empty for `Nothing`.
std::string textOf(Beyond beyond);

}  // namespace alidade
