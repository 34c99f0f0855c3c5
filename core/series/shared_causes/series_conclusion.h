#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/series/shared_causes/common_noise.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/series/shared_causes/shared_search.h"

namespace alidade {

/// What the sessions of a series say together, before each is looked at again.
struct SeriesConclusion {
  SeriesDiagnosis diagnosis;  ///< without `sessions`, but for their order
  /// What the other sessions say of the effects a session shares.
  std::vector<std::vector<KnownNumber>> known;
  std::vector<std::vector<std::string>> own;  ///< ids of what each session holds by itself
  std::vector<double> ownChance;
};

SeriesConclusion concludeSeries(const std::vector<SessionEvidence>& evidence,
                                const std::vector<SessionOwners>& owners,
                                const std::vector<std::string>& names,
                                const std::vector<std::string>& leftOut, const std::stop_token& stop);

}  // namespace alidade
