#include "core/series/shared_causes/searched_series.h"

#include <algorithm>
#include <functional>

namespace alidade {

void addCandidates(SeriesDiagnosis& diagnosis, const SearchedSeries& series) {
  for (const EffectBlock& block : series.blocks) {
    if (series.stop.stop_requested()) return;
    if (block.isPattern()) continue;
    if (block.sizes != SizesKind::One && block.owner != CauseOwner::Time) continue;
    const ColumnGain gain = series.search.alone(block);
    const SharedSet set = series.search.fitted({block}, std::vector<std::size_t>(series.sessions(), 0));
    const Candidate candidate{std::string(block.columns().effect->id), gain.log,
                              series.search.visibleLength(set.parts.front())};
    const auto same = std::ranges::find(diagnosis.candidates, candidate.effect, &Candidate::effect);
    if (same == diagnosis.candidates.end())
      diagnosis.candidates.push_back(candidate);
    else if (same->logBayesFactor < candidate.logBayesFactor)
      *same = candidate;
  }
  std::ranges::sort(diagnosis.candidates, std::greater{}, &Candidate::logBayesFactor);
}

}  // namespace alidade
