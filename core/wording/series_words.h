#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade {

// Sentences on a series of sessions.

/// How sizes are given if sessions have vertical circles of both kinds.
std::string bothCirclesSentence();

/// "instrument T-1", "guideway G-1", "the session by itself".
std::string ownerText(const SharedCause& cause);
/// "radius along the guideway (7 periods in a turn), guideway G-1".
std::string patternText(const SharedPattern& pattern);
/// The result of the sessions together.
std::string sentenceOf(const SeriesDiagnosis& series);
/// "Measure guideway G-1 with instrument T-2: separates A and B by 4.3 σ (sessions needed: 2)."
std::string sentenceOf(const SeriesAdvice& advice);
/// States the form with the u of its amplitude, and names the sessions that show the form.
std::string sentenceOf(const OfferedEffect& offered, const SeriesDiagnosis& series);
/// Findings on copies, on sessions that do not state the serial of instrument or guideway, and on sessions in
/// which a shared cause has another size.
std::vector<Finding> findingsOf(const SeriesDiagnosis& series);

// Sentences on a file `copy` with the same readings as the file `first`. Both parameters are paths. The
// sentences use the file names, or the whole paths if the names are equal.

/// "holds the same readings as a.alidade: counted once"; the subject is `copy`.
std::string copyReason(const std::string& copy, const std::string& first);
/// "b.alidade holds the same readings as a.alidade: counted once."
std::string copySentence(const std::string& copy, const std::string& first);

}  // namespace alidade
