#include "app/console/commands/fit_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

#include "app/console/commands/option_checks.h"
#include "app/console/commands/shared_options.h"
#include "app/console/fit_text.h"
#include "app/console/own_effect_files.h"
#include "app/console/session_input.h"
#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/answers/beforehand.h"
#include "core/answers/csv_answers.h"
#include "core/answers/fit_json.h"
#include "core/diagnosis/diagnose.h"

namespace alidade::console {

namespace {

constexpr const char* asManyAsItTakes = "auto";

std::string tableOf(const std::string& kind, const FitAnswer& answer) {
  if (kind == "residuals") return residualsCsv(answer.measurement, answer.fit);
  if (kind == "budget") return budgetCsv(answer.fit, answer.found());
  return resultsCsv(answer);
}

Result<std::string> rigorousAnswer(const FitRequest& request, SessionInput input, VerdictExit& verdicts) {
  const Measurement& measurement = input.measurement;
  const SessionFit fit = fitSession(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  FitAnswer answer{input.name, measurement, fit,
                   findSuspects(input.session, measurement, fit, {.risk = request.risk})};
  answer.arrivals = arrivalsOf(input.session);
  answer.digest = input.digest;
  input.session = {};  // frees the memory of the rows
  if (!request.monteCarlo.empty()) {
    MonteCarloOptions options{.seed = request.seed};
    if (request.monteCarlo != asManyAsItTakes) options.draws = std::stoull(request.monteCarlo);
    answer.check = propagateDistributions(measurement, fit, options);
    if (!answer.check)
      return Problem{"so few draws of these readings fix a circle that nothing can be said of them"};
  }
  if (request.diagnosis)
    if (Result<Diagnosis, DiagnosisFault> diagnosis = diagnose(measurement, fit, {.withAttainable = true}))
      answer.diagnosis = *std::move(diagnosis);
  if (request.verdictExit) verdicts.take(decideAcceptance(measurement, fit, answer.found()));
  if (!request.csv.empty()) return tableOf(request.csv, answer);
  answer.dependences = dependencesOf(measurement, fit, answer.found());
  return request.batch.json ? fitJson(answer) : fitText(answer);
}

Result<std::string> publishedAnswer(const FitRequest& request, const SessionInput& input) {
  const Measurement& measurement = input.measurement;
  const PublishedSessionFit fit = fitSessionAsPublished(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  return request.batch.json ? fitJson(input.name, measurement, fit, input.digest) : fitText(input.name, fit);
}

}  // namespace

void addFitCommand(CLI::App& app, FitRequest& request) {
  CLI::App* fit = app.add_subcommand("fit", "Arc centres O1 and O2, intersection, uncertainty and verdict.");
  fit->add_option("FILE", request.files,
                  "Session to fit (*.alidade); several, or a folder of them, are each answered; - reads "
                  "standard input")
      ->required();
  fit->add_option("--method", request.method, "rigorous, or published for comparison with the paper")
      ->check(CLI::IsMember({"rigorous", "published"}))
      ->capture_default_str();
  fit->add_option("--risk", request.risk, "Of naming a suspect in a session without misreadings")
      ->check(numberFrom(1e-9, 0.5))
      ->capture_default_str();
  constexpr std::size_t fewestDraws = 1000, mostDraws = 10000000;
  CLI::Option* draws = fit->add_option("--monte-carlo", request.monteCarlo,
                                       "Check the uncertainty by this many draws of all readings (JCGM 101); "
                                       "auto: as many as the result needs")
                           ->check([number = wholeFrom(fewestDraws, mostDraws)](const std::string& text) {
                             return text == asManyAsItTakes ? std::string() : number(text);
                           });
  fit->add_option("--seed", request.seed, "Of the draws; 1 if not given")->check(seedCheck())->needs(draws);
  fit->add_flag("!--no-diagnosis", request.diagnosis,
                "Do not ask what else the readings may say: the verdict is that of the session's own model");
  fit->add_option("--instrument", request.instrument,
                  "Take what this instrument record says (*.alidade-instrument), for this run");
  fit->add_option("--csv", request.csv,
                  "Print a table (RFC 4180) instead: residuals of every reading, budget of every "
                  "uncertainty, or results, those of many files in one table")
      ->check(CLI::IsMember({"residuals", "budget", "results"}));
  fit->add_flag("--verdict-exit", request.verdictExit,
                "Exit with 0 if accepted, 3 if rejected, 4 if undecided or without a verdict; of several "
                "sessions 3 if any is rejected, else 4 if any is undecided");
  addEffectsOption(*fit, request.effects);
  addBatchOptions(*fit, request.batch);
}

Result<std::string> runFit(const FitRequest& request, const std::string& file, VerdictExit& verdicts) {
  if (request.method == "published" && !request.monteCarlo.empty())
    return Problem{"the published method states no uncertainty to check: leave out --monte-carlo"};
  if (request.method == "published" && request.verdictExit)
    return Problem{"the published method gives no verdict: leave out --verdict-exit or --method"};
  if (!request.csv.empty() && request.batch.json)
    return Problem{"--csv and --json are two answers: leave out one of them"};
  if (!request.csv.empty() && request.method == "published")
    return Problem{"the published method has no tables: leave out --csv or --method"};
  if (!request.csv.empty() && request.csv != "results" && namesMany(request.files))
    return Problem{"--csv " + request.csv + " prints the table of one session: name one file"};
  Result<SessionInput> input = readSessionInput(file, request.instrument, request.effects);
  if (!input) return input.problem();
  return request.method == "published" ? publishedAnswer(request, *input)
                                       : rigorousAnswer(request, *std::move(input), verdicts);
}

}  // namespace alidade::console
