#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/result/diagnosis_fault.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/session/measurement.h"

namespace alidade {

// Diagnoses sessions of the same instruments and guideways together: each may be too short to show an effect
// that all share. An effect of an instrument has one size in all sessions with its serial number, an effect
// of a guideway likewise. An effect of time is not shared. The evidence of all sessions on a shared size adds
// up. A session may have causes of its own, such as misread values or a jump; they do not distort the sum.

/// A session as input.
struct SeriesSession {
  std::string name, measuredOn;                                    ///< date as YYYY-MM-DD; may be empty
  std::string instrumentName, instrument, guidewayName, guideway;  ///< names and serials
  Measurement measurement;
  std::string readings = {};  ///< `readingsDigest`; of sessions with equal digests only the first counts
  std::string file = {};      ///< source file; empty: use the name
};
SeriesSession seriesSession(std::string name, const Session& session, Measurement measurement);

struct SeriesOptions {
  std::vector<std::string> without = {};  ///< ids of effects that are not considered
  std::size_t threads = 0;                ///< 0: as many as the machine has; the result is the same for any
                                          ///< number
  bool withSessions = true;               ///< each session is also diagnosed using the others
  /// Called with the number of finished and of all sessions, one call at a time.
  std::function<void(std::size_t, std::size_t)> progress = {};
};

struct SeriesOutcome {
  SeriesDiagnosis diagnosis;
  /// Indices of the sessions that could not be diagnosed, with the reasons.
  std::vector<std::pair<std::size_t, DiagnosisFault>> unusable = {};
  /// Pairs of indices: a session that is not used, and the earlier session with the same readings.
  std::vector<std::pair<std::size_t, std::size_t>> copies = {};
};

/// Fails if no session can be diagnosed, if an id is unknown, or on request to stop.
Result<SeriesOutcome, DiagnosisFault> diagnoseSeries(const std::vector<SeriesSession>& sessions,
                                                     const SeriesOptions& options = {},
                                                     const std::stop_token& stop = {});

}  // namespace alidade
