#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// What is said of a series of sessions.

/// "instrument T-1", "guideway G-1", "the session by itself".
std::string ownerText(const SharedCause& cause);
/// What the sessions come to together.
std::string sentenceOf(const SeriesDiagnosis& series, const CauseNamer& name = byId);
/// "Measure guideway G-1 with instrument T-2: two sessions tell A and B apart, by 4.3 σ."
std::string sentenceOf(const SeriesAdvice& advice, const CauseNamer& name = byId);
/// Sessions whose owners are not known, and sessions that do not share what others do.
std::vector<Finding> findingsOf(const SeriesDiagnosis& series, const CauseNamer& name = byId);

}  // namespace alidade
