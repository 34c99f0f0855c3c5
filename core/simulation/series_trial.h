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

// Blind trials of series: sessions with a common sealed truth, diagnosed together, and scored when the seal
// is opened.

/// The truth of a series.
struct SeriesSeal {
  std::string id;
  std::string kind = "none";  ///< a catalogued effect, an uncatalogued one, or none
  CauseOwner owner = CauseOwner::Time;
  std::string serial = {};  ///< of the owner; empty if the truth does not state it
  std::string protocol = {};
  std::optional<double> visible = {};  ///< length of the shared cause's trace in all sessions together, σ
  std::optional<std::size_t> spoiled = {};  ///< index of a session with a cause of its own
  std::string spoiledBy = {};               ///< id of this session's own cause
};

struct SeriesTrial {
  SeriesSeal seal;
  std::vector<Session> sessions;
};

/// Draws 8 to 12 sessions. They share no effect, or one effect of an instrument or a guideway, visible by 6
/// to 10 σ in all sessions together. A quarter of the series share an uncatalogued effect, visible by 8 to 16
/// σ and by at least 6 σ beyond any catalogued effect. Either two instruments and three guideways are
/// crossed, or each session has another guideway, or four instruments take turns at one guideway. In a third
/// of the series one session is spoiled. Half of these sessions have a large jump or scatter more as a whole.
/// The others have a misread value, a jump or another effect. The same seed gives the same trial.
Result<SeriesTrial> drawSeriesTrial(std::uint64_t seed);

struct ScoredSeries {
  SeriesSeal seal;
  bool isNamed = false;  ///< the truth is the first shared cause or one of its look-alikes; an uncatalogued
                         ///< truth: the verdict is NotInCatalogue, without a shared cause
  bool isFirst = false;  ///< the truth is the first shared cause itself
  bool isOwnerRight = false;
  bool isAlarm = false;         ///< a shared cause is named, or a shared uncatalogued gap reported
  bool isNoiseOfAll = false;    ///< larger noise of several sessions is reported
  bool isSpoilerFound = false;  ///< the spoiled session is found to have its own cause
  std::size_t namedAlone = 0, sessions = 0;  ///< of `sessions` sessions diagnosed alone, those that
                                             ///< name the truth, alone or in a group
  std::string answer;
};

ScoredSeries scoreSeries(const SeriesSeal& seal, const SeriesDiagnosis& diagnosis);

/// Draws, diagnoses and scores trials `seed` … `seed` + `count` − 1, in order.
Result<std::vector<ScoredSeries>> scoreDrawnSeries(std::size_t count, std::uint64_t seed,
                                                   std::size_t threads);

/// Scores stored series: `folder`/truth.json, an object of series with `kind`, `shared` and `sessions`, and
/// `folder`/SERIES/SESSION.alidade. Without `shared`, the owner is that of effects of this kind. Without
/// `sessions`, the keys of `intersection_mm` name the sessions. Truths of single sessions are skipped.
/// Problems name the file.
Result<std::vector<ScoredSeries>> scoreStoredSeries(const std::string& folder, std::size_t threads);

/// Whether truth.json in `folder` holds series, or sessions. An unreadable file counts as one of sessions.
bool holdsSeries(const std::string& folder);
bool holdsSessions(const std::string& folder);

}  // namespace alidade
