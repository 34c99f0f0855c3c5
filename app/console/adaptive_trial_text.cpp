#include "app/console/adaptive_trial_text.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/number_text.h"
#include "core/wording/effect_name.h"

namespace alidade::console {

namespace {

using Json = nlohmann::ordered_json;

struct OfOrder {
  std::size_t right = 0, wrong = 0;
  double sightings = 0, minutes = 0;

  void add(const WatchedRun& run) {
    right += run.isRight ? 1 : 0;
    wrong += run.isWrong ? 1 : 0;
    sightings += static_cast<double>(run.sightings);
    minutes += run.minutes;
  }
};

struct OfKind {
  std::size_t count = 0, rightInFull = 0, rows = 0;
  OfOrder ofProtocol, byWorth;

  void add(const AdaptiveTrial& trial) {
    ++count;
    rightInFull += trial.isRightInFull ? 1 : 0;
    rows += trial.rows;
    ofProtocol.add(trial.ofProtocol);
    byWorth.add(trial.byWorth);
  }
};

std::vector<std::string> kindRow(const std::string& kind, const OfKind& of) {
  const auto mean = [&](double sum) { return fixedText(sum / static_cast<double>(of.count), 1); };
  const auto right = [&](std::size_t hits) { return std::to_string(hits) + "/" + std::to_string(of.count); };
  return {"  " + causeName(kind),
          right(of.rightInFull),
          mean(static_cast<double>(of.rows)),
          right(of.ofProtocol.right),
          std::to_string(of.ofProtocol.wrong),
          mean(of.ofProtocol.sightings),
          mean(of.ofProtocol.minutes),
          right(of.byWorth.right),
          std::to_string(of.byWorth.wrong),
          mean(of.byWorth.sightings),
          mean(of.byWorth.minutes)};
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

}  // namespace

std::string adaptiveTrialText(const AdaptiveTrials& trials) {
  std::map<std::string, OfKind> kinds;
  OfKind all;
  for (const AdaptiveTrial& trial : trials.withCause) {
    kinds[trial.truth.kind].add(trial);
    all.add(trial);
  }
  std::string text;
  if (all.count > 0) {
    std::vector<std::vector<std::string>> rows{{"  kind", "whole: right", "sightings", "protocol: right",
                                                "wrong", "sightings", "minutes", "chosen: right", "wrong",
                                                "sightings", "minutes"}};
    for (const auto& [kind, of] : kinds) rows.push_back(kindRow(kind, of));
    rows.push_back(kindRow("all", all));
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

}  // namespace alidade::console
