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
/// "Measure guideway G-1 with instrument T-2: separates A and B by 4.3 σ (sessions needed: 2)."
std::string sentenceOf(const SeriesAdvice& advice);
/// States the form with the u of its amplitude, and names the sessions that show the form.
std::string sentenceOf(const OfferedEffect& offered, const SeriesDiagnosis& series);
/// Findings on copies, on sessions that do not state the serial of instrument or guideway, and on sessions in
/// which a shared cause has another size.
std::vector<Finding> findingsOf(const SeriesDiagnosis& series);

}  // namespace alidade
