#pragma once

#include <string>

#include "core/series/shared_causes/series_diagnosis.h"

namespace alidade {

/// One JSON document: `series` with the keys of a session's diagnosis, each cause with its owner and
/// sessions, and `sessions`, each in the light of the series. `name` is what the series is called.
std::string seriesJson(const std::string& name, const SeriesDiagnosis& series);

}  // namespace alidade
