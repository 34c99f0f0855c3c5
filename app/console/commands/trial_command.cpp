#include "app/console/commands/trial_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/console/commands/option_checks.h"
#include "app/console/own_effect_files.h"
#include "app/console/trial_text.h"
#include "core/simulation/protocol.h"

namespace alidade::console {

namespace {

/// Prints progress to stderr from time to time during a long series.
void report(std::size_t done) {
  constexpr std::size_t every = 100;
  if (done % every == 0) std::fprintf(stderr, "alidade-cli: %zu trials done\n", done);
}

Result<std::string> adaptiveTrialsOf(const TrialRequest& request) {
  const AdaptiveTrialOptions options{.count = request.count,
                                     .two = request.two,
                                     .unknown = request.unknown,
                                     .clean = request.clean,
                                     .readsCleanInOrder = request.csv,
                                     .threads = request.threads,
                                     .progress = report};
  const auto trials = adaptiveTrials(options, *protocolByName(request.protocol), request.seed);
  if (!trials) return trials.problem();
  if (request.csv) return adaptiveTrialCsv(*trials);
  return request.json ? adaptiveTrialJson(*trials) : adaptiveTrialText(*trials);
}

Result<std::string> sessionTrials(const TrialRequest& request) {
  const Result<std::vector<OwnEffect>> own = ownEffectsIn(request.effects);
  if (!own) return own.problem();
  std::vector<Problem> problems;
  const BlindTrialOptions draw{.protocol = request.protocol, .own = examineOwnEffects(*own, problems)};
  if (!problems.empty()) return Problem{"--effects: " + problems.front().text()};
  const TrialSeriesOptions options{.count = request.count,
                                   .withheld = request.withheld,
                                   .own = *own,
                                   .threads = request.threads,
                                   .progress = report};
  const Result<std::vector<ScoredTrial>> trials = request.folder.empty()
                                                      ? scoreDrawnTrials(options, draw, request.seed)
                                                      : scoreStoredTrials(options, request.folder);
  if (!trials) return trials.problem();
  const TrialSummary summary = summarise(*trials);
  return request.json ? trialJson(*trials, summary) : trialText(*trials, summary);
}

}  // namespace

void addTrialCommand(CLI::App& app, TrialRequest& request) {
  constexpr std::size_t mostTrials = 1000000;
  constexpr unsigned mostThreads = 1024;
  CLI::App* trial = app.add_subcommand(
      "trial", "Blind trials: draw a sealed truth, simulate, diagnose, and compare when the seal is opened.");
  CLI::Option* count = trial->add_option("--count", request.count, "Number of trials")
                           ->check(wholeFrom(1, mostTrials))
                           ->capture_default_str();
  CLI::Option* seed = trial
                          ->add_option("--seed", request.seed,
                                       "Whole number that fixes everything drawn; trial i has seed + i")
                          ->check(seedCheck())
                          ->capture_default_str();
  std::vector<std::string> names;
  for (const Protocol& protocol : namedProtocols()) names.push_back(protocol.name);
  CLI::Option* protocol =
      trial->add_option("--protocol", request.protocol, "Plan of readings; drawn if not given")
          ->check(CLI::IsMember(names));
  CLI::Option* series =
      trial
          ->add_option("--series", request.series,
                       "Instead of sessions this many series of 8 to 12 that share an effect, or nothing")
          ->check(wholeFrom(1, mostTrials))
          ->excludes(count)
          ->excludes(protocol);
  trial
      ->add_option("--score", request.folder,
                   "Score trials made elsewhere: a folder with truth.json and the sessions, in sessions/ or "
                   "next to it, or with truth.json of series and SERIES/*.alidade")
      ->excludes(count)
      ->excludes(series)
      ->excludes(seed)
      ->excludes(protocol)
      ->check([](const std::string& folder) {
        return folder.empty() ? "names no folder: give the one that holds truth.json and sessions/" : "";
      });
  CLI::Option* effects =
      trial
          ->add_option(
              "--effects", request.effects,
              "Effects of your own (*.alidade-effect, or a folder of them): drawn as often as one of the "
              "catalogue, and known to the diagnosis; may be given several times")
          ->take_all()
          ->expected(1)
          ->excludes(series);
  CLI::Option* withheld = trial->add_flag(
      "--withheld", request.withheld,
      "Diagnose each effect a second time with itself taken from the catalogue: no wrong cause may "
      "be blamed");
  CLI::Option* adaptive = trial
                              ->add_flag("--adaptive", request.adaptive,
                                         "Read each truth, one effect, twice until its causes are named: in "
                                         "the order of the protocol, and each time the most informative "
                                         "sighting for its minutes")
                              ->needs(protocol)
                              ->excludes(series)
                              ->excludes(effects)
                              ->excludes(withheld);
  trial
      ->add_option("--two", request.two,
                   "With --adaptive also this many sessions with two effects, which are both to be named")
      ->check(wholeFrom(1, mostTrials))
      ->needs(adaptive);
  trial
      ->add_option(
          "--unknown", request.unknown,
          "With --adaptive also this many sessions with an effect of no catalogue, which is to be named "
          "as a form")
      ->check(wholeFrom(1, mostTrials))
      ->needs(adaptive);
  trial
      ->add_option(
          "--clean", request.clean,
          "With --adaptive also this many sessions with nothing to name, watched after every sighting")
      ->check(wholeFrom(1, mostTrials))
      ->needs(adaptive);
  trial->add_option("--threads", request.threads, "Threads to use; 0: all. The result does not depend on it")
      ->check(wholeFrom(0, mostThreads))
      ->capture_default_str();
  CLI::Option* json = trial->add_flag("--json", request.json, "Print one JSON document");
  trial
      ->add_flag(
          "--csv", request.csv,
          "With --adaptive print curves instead: right and wrong answers and U of Δd against sightings and "
          "minutes, in both ways")
      ->needs(adaptive)
      ->excludes(json);
}

Result<std::string> runTrial(const TrialRequest& request) {
  const bool isStoredSeries = !request.folder.empty() && holdsSeries(request.folder);
  if (request.series > 0 || isStoredSeries) {
    const auto series = isStoredSeries ? scoreStoredSeries(request.folder, request.threads)
                                       : scoreDrawnSeries(request.series, request.seed, request.threads);
    if (!series) return series.problem();
    const std::string text = request.json ? seriesTrialJson(*series) : seriesTrialText(*series);
    if (!isStoredSeries || !holdsSessions(request.folder)) return text;
    const Result<std::string> sessions = sessionTrials(request);
    if (!sessions) return sessions.problem();
    return request.json ? "{\"sessions\": " + *sessions + ", \"series\": " + text + "}\n"
                        : *sessions + "\n" + text;
  }
  return request.adaptive ? adaptiveTrialsOf(request) : sessionTrials(request);
}

}  // namespace alidade::console
