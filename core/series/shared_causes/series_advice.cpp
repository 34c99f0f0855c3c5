#include "core/series/shared_causes/searched_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alidade {

namespace {

/// Number of sessions that make a cause clear if its trace in each of them is `inOne` σ.
int sessionsFor(double inOne) {
  constexpr double most = 99;
  return static_cast<int>(
      std::clamp(std::ceil(std::pow(clearlySeparated() / std::max(inOne, 1e-9), 2)), 1.0, most));
}

/// Advises further sessions if a cause is possible but still too faint.
void addMore(SeriesDiagnosis& diagnosis, const SearchedSeries& series) {
  constexpr double likely = 0.2, clear = 6;  // probability; combined σ from which a cause is named
  const auto best = std::ranges::find_if(
      series.sets, [](const SharedSet& set) { return !set.parts.empty() && !set.isShaped(); });
  if (best == series.sets.end() || best->chance < likely) return;
  const SharedPart& part = best->parts.front();
  const double together = series.search.visibleLength(part);
  const double inOne = together / std::sqrt(static_cast<double>(part.block.sessions.size()));
  if (part.block.owner == CauseOwner::Time || !(inOne > 0) || together >= clear) return;
  SeriesAdvice advice;
  if (part.block.owner == CauseOwner::Instrument) advice.instrument = part.block.serial;
  if (part.block.owner == CauseOwner::Guideway) advice.guideway = part.block.serial;
  advice.separates = {std::string(part.block.columns().effect->id)};
  advice.sessions = static_cast<int>(
      std::clamp(std::ceil((clear * clear - together * together) / (inOne * inOne)), 1.0, 99.0));
  advice.bySigma = std::sqrt(together * together + advice.sessions * inOne * inOne);
  diagnosis.advice.push_back(std::move(advice));
}

}  // namespace

void addAdvice(SeriesDiagnosis& diagnosis, const SearchedSeries& series) {
  const auto serialsOf = [&](CauseOwner kind) {
    std::vector<std::string> serials;
    for (const SessionOwners& owner : series.owners) {
      const std::string& serial = kind == CauseOwner::Instrument ? owner.instrument : owner.guideway;
      if (!serial.empty() && std::ranges::find(serials, serial) == serials.end()) serials.push_back(serial);
    }
    return serials;
  };
  const auto add = [&](const SharedCause& cause, const std::string& rival, CauseOwner changed) {
    SeriesAdvice advice;
    advice.what = changed == CauseOwner::Instrument ? SeriesAdvice::What::OtherInstrument
                                                    : SeriesAdvice::What::OtherGuideway;
    const SessionOwners& now = series.owners[cause.sessions.front()];
    // Without its serial number nobody can measure with the same one again.
    if ((changed == CauseOwner::Instrument ? now.guideway : now.instrument).empty()) return;
    const auto others = serialsOf(changed);
    const std::string& present = changed == CauseOwner::Instrument ? now.instrument : now.guideway;
    const auto other = std::ranges::find_if(others, [&](const std::string& s) { return s != present; });
    const std::string chosen = other == others.end() ? "" : *other;
    advice.instrument = changed == CauseOwner::Instrument ? chosen : now.instrument;
    advice.guideway = changed == CauseOwner::Instrument ? now.guideway : chosen;
    advice.separates = {cause.cause.effect, rival};
    advice.sessions = sessionsFor(cause.visibleInOne);
    advice.bySigma = cause.visibleInOne * std::sqrt(advice.sessions);
    diagnosis.advice.push_back(std::move(advice));
  };
  for (const SharedCause& cause : diagnosis.causes) {
    if (cause.owner == CauseOwner::Time || !(cause.visibleInOne > 0)) continue;
    const auto rival = std::ranges::find_if(cause.rivals, [&](const SharedRival& other) {
      return other.owner != cause.owner && other.owner != CauseOwner::Time;
    });
    if (rival == cause.rivals.end()) continue;
    add(cause, rival->effect, CauseOwner::Instrument);
    add(cause, rival->effect, CauseOwner::Guideway);
  }
  const bool isShared = std::ranges::any_of(
      diagnosis.causes, [](const SharedCause& cause) { return cause.owner != CauseOwner::Time; });
  if (isShared || series.sets.empty()) return;
  addMore(diagnosis, series);
}

}  // namespace alidade
