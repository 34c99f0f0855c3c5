#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "core/series/shared_causes/series_diagnosis.h"
#include "core/series/shared_causes/shared_search.h"

namespace alidade {

/// The input and the results of the search, from which all statements except the causes are derived.
struct SearchedSeries {
  const std::vector<SessionEvidence>& evidence;
  const std::vector<SessionOwners>& owners;
  const std::vector<std::string>& names;    ///< of the sessions
  const std::vector<std::string>& leftOut;  ///< ids of effects that are not considered
  const std::stop_token& stop;
  const std::vector<SessionSums>& sums;
  const std::vector<EffectBlock>& blocks;
  const SharedSearch& search;
  const std::vector<SharedSet>& sets;  ///< the likeliest first
  const SharedSet& best;

  std::size_t sessions() const { return evidence.size(); }
};

/// Adds how well each effect alone explains the sessions.
void addCandidates(SeriesDiagnosis& diagnosis, const SearchedSeries& series);

/// Adds the shares of the gap: by owner of the causes, by session, instrument and guideway.
void addWhere(SeriesDiagnosis& diagnosis, const SearchedSeries& series);

/// Adds the effects that at plausible size would move the mean Δd of the sessions, but are undetectable in
/// all sessions together.
void addUndetectable(SeriesDiagnosis& diagnosis, const SearchedSeries& series);

/// Adds advice on further sessions: they separate look-alikes of different owners, or clarify a faint cause.
void addAdvice(SeriesDiagnosis& diagnosis, const SearchedSeries& series);

}  // namespace alidade
