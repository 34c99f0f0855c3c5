#pragma once

#include <string>

#include "core/answers/fit_answer.h"

namespace alidade {

/// A table of the results, a quantity to a row: Δd as measured and of the fit alone, Δz and the distance from
/// the axis where they were measured, |O1 − O2|/2, and centre, radius and rms of each arc. Lengths in mm, y
/// up, angles in arcseconds: the unit stands in the row. A cell is empty where there is no finite number.
std::string resultsCsv(const FitAnswer& answer);

}  // namespace alidade
