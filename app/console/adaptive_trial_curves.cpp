#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "app/console/adaptive_trial_text.h"
#include "core/base/number_text.h"

namespace alidade::console {

namespace {

/// A way to read a session, and what its progress is measured by.
struct Axis {
  const char* way;
  WatchedRun WatchedRuns::*run;
  const char* unit;
  bool isMinutes;

  double lengthOf(const WatchedRun& watched) const {
    return isMinutes ? watched.minutes : static_cast<double>(watched.sightings);
  }
};

constexpr Axis axes[] = {{"in_order", &WatchedRuns::ofProtocol, "sightings", false},
                         {"by_worth", &WatchedRuns::byWorth, "sightings", false},
                         {"in_order", &WatchedRuns::ofProtocol, "minutes", true},
                         {"by_worth", &WatchedRuns::byWorth, "minutes", true}};

std::string line(const std::string& kind, const Axis& axis, double at, const std::string& shares,
                 const std::string& expanded) {
  return kind + "," + axis.way + "," + axis.unit + "," + fixedText(at, 0) + "," + shares + "," + expanded +
         "\n";
}

/// The shares of sessions that were named by `at`, in percent: rightly, wrongly.
std::string sharesAt(const std::vector<const AdaptiveTrial*>& trials, const Axis& axis, double at) {
  double right = 0, wrong = 0;
  for (const AdaptiveTrial* trial : trials)
    if (const WatchedRun& run = trial->*axis.run; !run.named.empty() && axis.lengthOf(run) <= at)
      ++(run.isRight ? right : wrong);
  const double percent = 100 / static_cast<double>(trials.size());
  return fixedText(percent * right, 1) + "," + fixedText(percent * wrong, 1);
}

/// Mean U of the clean sessions at `at`; empty until each of them has one.
std::string expandedAt(const std::vector<WatchedRuns>& clean, const Axis& axis, double at) {
  double sum = 0;
  for (const WatchedRuns& runs : clean) {
    const std::vector<WatchedRun::Look>& looks = (runs.*axis.run).looks;
    const auto after = std::ranges::find_if(looks, [&](const WatchedRun::Look& look) {
      return (axis.isMinutes ? look.minutes : static_cast<double>(look.sightings)) > at;
    });
    if (after == looks.begin()) return {};
    sum += std::prev(after)->expanded;
  }
  return clean.empty() ? std::string() : fixedText(sum / static_cast<double>(clean.size()), 4);
}

}  // namespace

std::string adaptiveTrialCsv(const AdaptiveTrials& trials) {
  std::map<std::string, std::vector<const AdaptiveTrial*>> kinds;
  for (const AdaptiveTrial& trial : trials.withCause) {
    kinds[trial.truth.kind].push_back(&trial);
    kinds["all"].push_back(&trial);
  }
  std::string text = "kind,way,against,at,right_percent,wrong_percent,expanded_mm\n";
  for (const Axis& axis : axes) {
    double last = 0;
    for (const AdaptiveTrial& trial : trials.withCause) last = std::max(last, axis.lengthOf(trial.*axis.run));
    for (const WatchedRuns& runs : trials.clean) last = std::max(last, axis.lengthOf(runs.*axis.run));
    constexpr double step = 4;
    for (double at = step; at < last + step; at += step) {
      for (const auto& [kind, own] : kinds) text += line(kind, axis, at, sharesAt(own, axis, at), "");
      if (const std::string expanded = expandedAt(trials.clean, axis, at); !expanded.empty())
        text += line("none", axis, at, ",", expanded);
    }
  }
  return text;
}

}  // namespace alidade::console
