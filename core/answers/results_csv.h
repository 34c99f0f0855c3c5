#pragma once

#include <string>

#include "core/answers/fit_answer.h"

namespace alidade {

/// Returns a table of the results, one quantity in each row: Δd, measured and fit only; Δz and the distance
/// from the axis, if measured; |O1 − O2|/2; centre, radius and rms of each arc. Lengths are in mm, y up,
/// angles in arcseconds, as the unit of the row states. A cell is empty if its number is not finite.
std::string resultsCsv(const FitAnswer& answer);

}  // namespace alidade
