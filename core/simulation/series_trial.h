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
  std::string kind = "none";  ///< an effect of the catalogue, one of no catalogue, or none
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
/// them together, or, in a quarter of the series, one of no catalogue that shows by 8 to 16 σ and by 6 σ and
/// more beside any effect of the catalogue. Either each session has another guideway (or instrument), or two
/// instruments and three guideways are crossed. A third of them has one session spoiled: by a misread value,
/// by a knocked tripod, or by another effect; in half of these the knock is a hard one, or the whole session
/// scatters more. The same seed gives the same trial.
Result<SeriesTrial> drawSeriesTrial(std::uint64_t seed);

struct ScoredSeries {
  SeriesSeal seal;
  bool isNamed = false;  ///< the truth is the first shared cause, or in its group; of no catalogue: told so
  bool isFirst = false;  ///< it is that cause
  bool isOwnerRight = false;
  bool isAlarm = false;         ///< a shared cause is named, or a shared gap of no catalogue told
  bool isNoiseOfAll = false;    ///< larger noise of several sessions is told
  bool isSpoilerFound = false;  ///< the spoiled session is told to hold a cause of its own
  std::size_t namedAlone = 0, sessions = 0;  ///< sessions that name it, or have it in their group, alone
  std::string answer;
};

ScoredSeries scoreSeries(const SeriesSeal& seal, const SeriesDiagnosis& diagnosis);

/// Draws, diagnoses and scores trials `seed` … `seed` + `count` − 1, in their order.
Result<std::vector<ScoredSeries>> scoreDrawnSeries(std::size_t count, std::uint64_t seed,
                                                   std::size_t threads);

/// Series made elsewhere: `folder`/truth.json, an object of series with `kind`, `shared` and `sessions`, and
/// `folder`/SERIES/SESSION.alidade; where the truth does not say `shared`, the owner is the one that an
/// effect of this kind has, and where it holds no `sessions`, they are those of its `intersection_mm`. Truths
/// of sessions beside them are passed over. The sentence of a problem names the file.
Result<std::vector<ScoredSeries>> scoreStoredSeries(const std::string& folder, std::size_t threads);

/// Does the truth file hold series, and does it hold sessions?
bool holdsSeries(const std::string& folder);
bool holdsSessions(const std::string& folder);

}  // namespace alidade
