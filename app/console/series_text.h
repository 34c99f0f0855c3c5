#pragma once

#include <string>

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade::console {

/// The result of a series as text for a terminal. `name` is the name of the series.
std::string seriesText(const std::string& name, const SeriesDiagnosis& series);

}  // namespace alidade::console
