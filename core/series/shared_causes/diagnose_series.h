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

// The situation: sessions of the same instruments and guideways, each too short to show an effect that all of
// them share. An effect of an instrument has one size in all sessions with its serial, one of a guideway in
// all with that serial, one of time in none; what one session says of that size adds to what the others say.
// Beside it each session may hold causes of its own, misread values or a knock, which do not spoil the sum.

/// A session as it is handed in.
struct SeriesSession {
  std::string name, measuredOn;                                    ///< date as YYYY-MM-DD; may be empty
  std::string instrumentName, instrument, guidewayName, guideway;  ///< names and serials
  Measurement measurement;
  std::string readings = {};  ///< `readingsDigest`; of sessions with the same the first alone counts
  std::string file = {};      ///< it was read from; empty: called by its name
};
SeriesSession seriesSession(std::string name, const Session& session, Measurement measurement);

struct SeriesOptions {
  std::vector<std::string> without = {};  ///< ids of effects that are not considered
  std::size_t threads = 0;                ///< 0: as many as the machine has; the result does not depend on it
  bool withSessions = true;               ///< each session is diagnosed in the light of the others, too
  /// Called with how many sessions of all are done, one call at a time.
  std::function<void(std::size_t, std::size_t)> progress = {};
};

struct SeriesOutcome {
  SeriesDiagnosis diagnosis;
  /// Sessions that could not be diagnosed, by their index; the others are.
  std::vector<std::pair<std::size_t, DiagnosisFault>> unusable = {};
  /// Sessions that hold the same readings as one before them, which counts for both: each with that.
  std::vector<std::pair<std::size_t, std::size_t>> copies = {};
};

/// Fails where no session can be diagnosed, an id is unknown, or it was asked to stop.
Result<SeriesOutcome, DiagnosisFault> diagnoseSeries(const std::vector<SeriesSession>& sessions,
                                                     const SeriesOptions& options = {},
                                                     const std::stop_token& stop = {});

}  // namespace alidade
