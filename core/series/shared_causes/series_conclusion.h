#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/series/shared_causes/common_noise.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/series/shared_causes/shared_search.h"

namespace alidade {

/// The combined result of a series, before each session is diagnosed again.
struct SeriesConclusion {
  SeriesDiagnosis diagnosis;  ///< `sessions` is empty
  /// For each session, the sizes of its shared effects as determined by other sessions.
  std::vector<std::vector<KnownNumber>> known;
  std::vector<std::vector<std::string>> own;  ///< for each session, the ids of its own causes
  std::vector<double> ownChance;
};

/// `evidence`: of at least one session; all sessions have the same columns.
SeriesConclusion concludeSeries(const std::vector<SessionEvidence>& evidence,
                                const std::vector<SessionOwners>& owners,
                                const std::vector<std::string>& names,
                                const std::vector<std::string>& leftOut, const std::stop_token& stop);

}  // namespace alidade
