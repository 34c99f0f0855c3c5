#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// Sentences on a series of sessions.

/// "instrument T-1", "guideway G-1", "the session by itself".
std::string ownerText(const SharedCause& cause);
/// The result of the sessions together.
std::string sentenceOf(const SeriesDiagnosis& series);
/// "Measure guideway G-1 with instrument T-2: tells A and B apart by 4.3 σ (sessions needed: 2)."
std::string sentenceOf(const SeriesAdvice& advice);
/// The form with u and the sessions that show it.
std::string sentenceOf(const OfferedEffect& offered, const SeriesDiagnosis& series);
/// Sessions without known owners, and sessions that do not share a cause of the others.
std::vector<Finding> findingsOf(const SeriesDiagnosis& series);

}  // namespace alidade
