#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/series/shared_causes/series_diagnosis.h"
#include "core/session/session.h"

namespace alidade {

// Blind trials of series: sessions of one truth that they share, sealed, diagnosed together, and scored when
// the seal is opened.

/// What a series holds.
struct SeriesSeal {
  std::string id;
  std::string kind = "none";  ///< an effect of the catalogue, or none
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};  ///< of the owner; empty where the truth does not say
  std::string protocol = {};
  std::optional<double> visible = {};       ///< of all sessions together, σ
  std::optional<std::size_t> spoiled = {};  ///< a session with a cause of its own, its index
  std::string spoiledBy = {};               ///< that
};

struct SeriesTrial {
  SeriesSeal seal;
  std::vector<Session> sessions;
};

/// 8 to 12 sessions: nothing, or one effect of an instrument or a guideway that shows by 6 to 10 σ in all of
/// them together. Either each session has another guideway (or instrument), or two instruments and three
/// guideways are crossed. A third of them has one session spoiled: by a misread value, by a knocked tripod,
/// or by another effect. The same seed gives the same trial.
Result<SeriesTrial> drawSeriesTrial(std::uint64_t seed);

struct ScoredSeries {
  SeriesSeal seal;
  bool isNamed = false;  ///< the truth is the first shared cause, or in its group
  bool isFirst = false;  ///< it is that cause
  bool isOwnerRight = false;
  bool isAlarm = false;                      ///< a shared cause is named
  bool isSpoilerFound = false;               ///< the spoiled session is told to hold a cause of its own
  std::size_t namedAlone = 0, sessions = 0;  ///< sessions that name it, or have it in their group, alone
  std::string answer;
};

ScoredSeries scoreSeries(const SeriesSeal& seal, const SeriesDiagnosis& diagnosis);

/// Draws, diagnoses and scores trials `seed` … `seed` + `count` − 1, in their order.
Result<std::vector<ScoredSeries>> scoreDrawnSeries(std::size_t count, std::uint64_t seed,
                                                   std::size_t threads);

/// Series made elsewhere: `folder`/truth.json, an object of series with `kind`, `shared` and `sessions`, and
/// `folder`/SERIES/SESSION.alidade. The sentence of a problem names the file.
Result<std::vector<ScoredSeries>> scoreStoredSeries(const std::string& folder, std::size_t threads);

/// Is this a truth file of series, rather than of sessions?
bool holdsSeries(const std::string& folder);

}  // namespace alidade
