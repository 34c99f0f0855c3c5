#pragma once

#include <string>

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// Returns one JSON document. `series` has the keys of a session's diagnosis, and owner and sessions for each
/// cause. `sessions` are the diagnoses that use the series. `name` is the name of the series.
std::string seriesJson(const std::string& name, const SeriesDiagnosis& series);

}  // namespace alidade
