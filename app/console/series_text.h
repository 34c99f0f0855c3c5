#pragma once

#include <string>

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade::console {

/// What a series answers, for reading on a terminal. `name` is what the series is called.
std::string seriesText(const std::string& name, const SeriesDiagnosis& series);

}  // namespace alidade::console
