#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/console/adaptive_trial_text.h"
#include "core/base/number_text.h"
#include "core/exchange/csv_text.h"

namespace alidade::console {

namespace {

/// An order of sightings, and the unit in which its progress is measured.
struct Axis {
  const char* way;
  WatchedRun WatchedRuns::*run;
  const char* unit;
  bool isMinutes;

  /// The length of a run, or of the run up to a `Look`, in minutes or sightings.
  template <typename Watched>
  double lengthOf(const Watched& watched) const {
    return isMinutes ? watched.minutes : static_cast<double>(watched.sightings);
  }
};

constexpr Axis axes[] = {{"in_order", &WatchedRuns::ofProtocol, "sightings", false},
                         {"by_worth", &WatchedRuns::byWorth, "sightings", false},
                         {"in_order", &WatchedRuns::ofProtocol, "minutes", true},
                         {"by_worth", &WatchedRuns::byWorth, "minutes", true}};

struct Shares {
  double right = 0, wrong = 0;  ///< percent
};

/// The shares, in percent, of trials whose run is at most `at` long and names causes rightly, or wrongly.
Shares sharesAt(const std::vector<const AdaptiveTrial*>& trials, const Axis& axis, double at) {
  std::size_t right = 0, wrong = 0;
  for (const AdaptiveTrial* trial : trials)
    if (const WatchedRun& run = trial->*axis.run; !run.named.empty() && axis.lengthOf(run) <= at) {
      right += run.isRight ? 1 : 0;
      wrong += run.isWrong ? 1 : 0;
    }
  const double percent = 100 / static_cast<double>(trials.size());
  return {percent * static_cast<double>(right), percent * static_cast<double>(wrong)};
}

/// The mean U of the clean sessions at the length `at`, mm; absent until each of them has a U.
std::optional<double> expandedAt(const std::vector<WatchedRuns>& clean, const Axis& axis, double at) {
  if (clean.empty()) return std::nullopt;
  double sum = 0;
  for (const WatchedRuns& runs : clean) {
    const std::vector<WatchedRun::Look>& looks = (runs.*axis.run).looks;
    const auto after =
        std::ranges::find_if(looks, [&](const WatchedRun::Look& look) { return axis.lengthOf(look) > at; });
    if (after == looks.begin()) return std::nullopt;
    sum += std::prev(after)->expanded;
  }
  return sum / static_cast<double>(clean.size());
}

}  // namespace

std::string adaptiveTrialCsv(const AdaptiveTrials& trials) {
  std::map<std::string, std::vector<const AdaptiveTrial*>> kinds;
  for (const AdaptiveTrial& trial : trials.withCause) {
    kinds[trial.truth.kind].push_back(&trial);
    kinds["all"].push_back(&trial);
  }
  CsvText csv({"kind", "way", "against", "at", "right_percent", "wrong_percent", "expanded_mm"});
  const auto begin = [&](const std::string& kind, const Axis& axis, double at) -> CsvText& {
    return csv.word(kind).word(axis.way).word(axis.unit).word(fixedText(at, 0));
  };
  for (const Axis& axis : axes) {
    double last = 0;
    for (const AdaptiveTrial& trial : trials.withCause) last = std::max(last, axis.lengthOf(trial.*axis.run));
    for (const WatchedRuns& runs : trials.clean) last = std::max(last, axis.lengthOf(runs.*axis.run));
    constexpr double step = 4;
    for (double at = step; at < last + step; at += step) {
      for (const auto& [kind, own] : kinds) {
        const Shares shares = sharesAt(own, axis, at);
        begin(kind, axis, at).word(fixedText(shares.right, 1)).word(fixedText(shares.wrong, 1)).word({});
        csv.endRow();
      }
      if (const auto expanded = expandedAt(trials.clean, axis, at)) {
        begin("none", axis, at).word({}).word({}).word(fixedText(*expanded, 4));
        csv.endRow();
      }
    }
  }
  return csv.text();
}

}  // namespace alidade::console
