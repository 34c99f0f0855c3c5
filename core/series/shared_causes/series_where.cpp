#include "core/series/shared_causes/searched_series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/series/shared_causes/common_noise.h"

namespace alidade {

void addWhere(SeriesDiagnosis& diagnosis, const SearchedSeries& series) {
  double left = 0, own = 0;
  std::map<std::string, double> ofInstruments, ofGuideways;
  std::vector<double> excess;
  for (std::size_t s = 0; s < series.sessions(); ++s) {
    const double f = series.evidence[s].degreesOfFreedom;
    const SessionExplanation& explanation = series.sums[s].explanation(series.best.explanations[s]);
    excess.push_back(std::max(0.0, series.evidence[s].chiSquare - f));
    ofInstruments[series.owners[s].instrument] += excess.back();
    ofGuideways[series.owners[s].guideway] += excess.back();
    left += chiSquareLeft(series.sums[s], s, series.best) - f + static_cast<double>(explanation.directions);
    own += series.evidence[s].chiSquare - explanation.chiSquare;
  }
  std::map<CauseOwner, double> frames;
  for (const SharedPart& part : series.best.parts)
    frames[part.block.owner] += std::pow(series.search.visibleLength(part), 2);
  frames[CauseOwner::Time] += std::max(own, 0.0);
  const double noise = std::max(left, 0.0);
  double sum = noise;
  for (const auto& [owner, size] : frames) sum += size;
  const auto share = [&](const std::string& by, const std::string& of, double size, double whole) {
    diagnosis.where.push_back({by, of, whole > 0 ? size / whole : 0});
  };
  for (const CauseOwner owner : {CauseOwner::Guideway, CauseOwner::Instrument, CauseOwner::Time})
    share("frame", std::string(nameOf(owner)), frames[owner], sum);
  share("frame", "noise", sum > 0 ? noise : 1, sum > 0 ? sum : 1);
  const double whole = std::accumulate(excess.begin(), excess.end(), 0.0);
  for (std::size_t s = 0; s < series.sessions(); ++s) share("session", series.names[s], excess[s], whole);
  for (const auto& [serial, size] : ofInstruments)
    if (!serial.empty()) share("instrument", serial, size, whole);
  for (const auto& [serial, size] : ofGuideways)
    if (!serial.empty()) share("guideway", serial, size, whole);
}

}  // namespace alidade
