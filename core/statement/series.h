#pragma once

#include "core/series/shared_causes/series_diagnosis.h"
#include "core/statement/statement.h"

namespace alidade {

// The statements on sessions that are diagnosed together. A statement with nothing to state is empty. The
// result in sentences is `sentenceOf` (wording/series_words.h), the shares of the gap are `gapWhere`.

/// The causes that the sessions share, or the pattern: owner, size, number of sessions, probability, length
/// of the trace in one session and in all, look-alikes. Parts of a row give the sizes in single sessions if
/// they differ.
Statement seriesCauses(const SeriesDiagnosis& series);

/// The residuals of all sessions, fit only and with the shared causes; how much held-out sessions shrink.
Statement seriesStages(const SeriesDiagnosis& series);

/// Each session with its date, instrument, guideway, and its verdict alone and within the series, in the
/// order of measurement. The id of a row is the number of its file among the input.
Statement seriesSessions(const SeriesDiagnosis& series);

/// What to measure next, in sentences.
Statement seriesAdvice(const SeriesDiagnosis& series);

/// The effects that no session and not all of them together can detect.
Statement seriesUndetectable(const SeriesDiagnosis& series);

}  // namespace alidade
