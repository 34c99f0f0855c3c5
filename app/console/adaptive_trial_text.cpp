#include "app/console/trial_text.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/number_text.h"
#include "core/exchange/csv_text.h"
#include "core/wording/effect_name.h"

namespace alidade::console {

namespace {

using Json = nlohmann::ordered_json;
using Trials = std::vector<const AdaptiveTrial*>;

/// The trials of each kind of truth, and under "all" every one.
std::map<std::string, Trials> byKind(const AdaptiveTrials& trials) {
  std::map<std::string, Trials> kinds;
  for (const AdaptiveTrial& trial : trials.withCause) {
    kinds[trial.truth.kind].push_back(&trial);
    kinds["all"].push_back(&trial);
  }
  return kinds;
}

std::vector<std::string> kindRow(const std::string& kind, const Trials& trials) {
  const auto sum = [&](const auto& numberOf) {
    double total = 0;
    for (const AdaptiveTrial* trial : trials) total += static_cast<double>(numberOf(*trial));
    return total;
  };
  const auto count = [&](const auto& isOne) { return fixedText(sum(isOne), 0); };
  const auto share = [&](const auto& isOne) { return count(isOne) + "/" + std::to_string(trials.size()); };
  const auto mean = [&](const auto& numberOf) {
    return fixedText(sum(numberOf) / static_cast<double>(trials.size()), 1);
  };
  std::vector<std::string> row{"  " + causeName(kind),
                               share([](const AdaptiveTrial& trial) { return trial.isRightInFull; }),
                               mean([](const AdaptiveTrial& trial) { return trial.rows; })};
  for (const auto run : {&WatchedRuns::ofProtocol, &WatchedRuns::byWorth}) {
    const auto of = [&](auto member) {
      return [=](const AdaptiveTrial& trial) { return trial.*run.*member; };
    };
    row.insert(row.end(), {share(of(&WatchedRun::isRight)), count(of(&WatchedRun::isWrong)),
                           mean(of(&WatchedRun::sightings)), mean(of(&WatchedRun::minutes))});
  }
  return row;
}

std::size_t namedIn(const std::vector<WatchedRuns>& runs) {
  return static_cast<std::size_t>(
      std::ranges::count_if(runs, [](const WatchedRuns& run) { return !run.byWorth.named.empty(); }));
}

Json runJson(const WatchedRun& run) {
  return {{"named", run.named},      {"also_named", run.alsoNamed}, {"right", run.isRight},
          {"wrong", run.isWrong},    {"sightings", run.sightings},  {"minutes", run.minutes},
          {"log_evidence", run.most}};
}

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

/// The percentage of trials whose run is at most `at` long and names causes rightly, or wrongly, as `is`
/// selects.
double percentAt(const Trials& trials, const Axis& axis, double at, bool WatchedRun::*is) {
  const auto isOne = [&](const AdaptiveTrial* trial) {
    const WatchedRun& run = trial->*axis.run;
    return !run.named.empty() && axis.lengthOf(run) <= at && run.*is;
  };
  return 100 / static_cast<double>(trials.size()) * static_cast<double>(std::ranges::count_if(trials, isOne));
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

std::string adaptiveTrialText(const AdaptiveTrials& trials) {
  std::map<std::string, Trials> kinds = byKind(trials);
  std::string text;
  if (!kinds.empty()) {
    std::vector<std::vector<std::string>> rows{{"  kind", "whole: right", "sightings", "protocol: right",
                                                "wrong", "sightings", "minutes", "chosen: right", "wrong",
                                                "sightings", "minutes"}};
    const auto all = kinds.extract("all");
    for (const auto& [kind, own] : kinds) rows.push_back(kindRow(kind, own));
    rows.push_back(kindRow("all", all.mapped()));
    text += "Until a cause is named, in the order of the protocol and by the worth of each sighting\n" +
            alignedColumns(rows);
  }
  if (!trials.clean.empty())
    text += "\nClean sessions, watched after every sighting: a cause named in " +
            std::to_string(namedIn(trials.clean)) + " of " + std::to_string(trials.clean.size()) + "\n";
  return text;
}

std::string adaptiveTrialJson(const AdaptiveTrials& trials) {
  Json withCause = Json::array(), clean = Json::array();
  for (const AdaptiveTrial& trial : trials.withCause)
    withCause.push_back({{"id", trial.truth.id},
                         {"kind", trial.truth.kind},
                         {"protocol", trial.truth.protocol},
                         {"rows", trial.rows},
                         {"right_in_full", trial.isRightInFull},
                         {"in_order", runJson(trial.ofProtocol)},
                         {"by_worth", runJson(trial.byWorth)}});
  for (const WatchedRuns& runs : trials.clean) clean.push_back(runJson(runs.byWorth));
  return answerText(Json{{"trials", withCause}, {"clean", clean}});
}

std::string adaptiveTrialCsv(const AdaptiveTrials& trials) {
  const std::map<std::string, Trials> kinds = byKind(trials);
  CsvText csv({"kind", "way", "against", "at", "right_percent", "wrong_percent", "expanded_mm"});
  for (const Axis& axis : axes) {
    double last = 0;
    for (const AdaptiveTrial& trial : trials.withCause) last = std::max(last, axis.lengthOf(trial.*axis.run));
    for (const WatchedRuns& runs : trials.clean) last = std::max(last, axis.lengthOf(runs.*axis.run));
    constexpr double step = 4;
    for (double at = step; at < last + step; at += step) {
      const auto add = [&](const std::string& kind, std::initializer_list<std::string> numbers) {
        csv.word(kind).word(axis.way).word(axis.unit).word(fixedText(at, 0));
        for (const std::string& number : numbers) csv.word(number);
        csv.endRow();
      };
      for (const auto& [kind, own] : kinds)
        add(kind, {fixedText(percentAt(own, axis, at, &WatchedRun::isRight), 1),
                   fixedText(percentAt(own, axis, at, &WatchedRun::isWrong), 1), ""});
      if (const auto expanded = expandedAt(trials.clean, axis, at))
        add("none", {"", "", fixedText(*expanded, 4)});
    }
  }
  return csv.text();
}

}  // namespace alidade::console
