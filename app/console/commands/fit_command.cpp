#include "app/console/commands/fit_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <utility>

#include "app/console/commands/batch_options.h"
#include "app/console/commands/option_checks.h"
#include "app/console/fit_text.h"
#include "app/console/session_input.h"
#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "core/adjustment/result/session_fit.h"
#include "core/answers/beforehand.h"
#include "core/answers/fit_json.h"
#include "core/diagnosis/diagnose.h"

namespace alidade::console {

namespace {

constexpr const char* asManyAsItTakes = "auto";

Result<std::string> rigorousAnswer(const FitRequest& request, SessionInput input) {
  const Measurement& measurement = input.measurement;
  const SessionFit fit = fitSession(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  FitAnswer answer{input.name, measurement, fit,
                   findSuspects(input.session, measurement, fit, {.risk = request.risk})};
  input.session = {};  // of no more use, and as long as its rows
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
  return request.batch.json ? fitJson(answer) : fitText(answer);
}

Result<std::string> publishedAnswer(const FitRequest& request, const std::string& name,
                                    const Measurement& measurement) {
  const PublishedSessionFit fit = fitSessionAsPublished(measurement);
  if (auto problem = absence(measurement, fit.arcs.size(), fit.findings)) return *std::move(problem);
  return request.batch.json ? fitJson(name, measurement, fit) : fitText(name, measurement, fit);
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
                                       "auto: as many as it takes to tell")
                           ->check([number = wholeFrom(fewestDraws, mostDraws)](const std::string& text) {
                             return text == asManyAsItTakes ? std::string() : number(text);
                           });
  fit->add_option("--seed", request.seed, "Of the draws; 1 if not given")->check(seedCheck())->needs(draws);
  fit->add_flag("!--no-diagnosis", request.diagnosis,
                "Do not ask what else the readings may say: the verdict is that of the session's own model");
  fit->add_option("--instrument", request.instrument,
                  "Take what this instrument record says (*.alidade-instrument), for this run");
  addBatchOptions(*fit, request.batch);
}

Result<std::string> runFit(const FitRequest& request, const std::string& file) {
  if (request.method == "published" && !request.monteCarlo.empty())
    return Problem{"the published method states no uncertainty to check: leave out --monte-carlo"};
  Result<SessionInput> input = readSessionInput(file, request.instrument);
  if (!input) return input.problem();
  return request.method == "published" ? publishedAnswer(request, input->name, input->measurement)
                                       : rigorousAnswer(request, *std::move(input));
}

}  // namespace alidade::console
