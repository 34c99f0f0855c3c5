#include "app/console/commands/plan_command.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "app/console/guidance_text.h"
#include "app/console/own_effect_files.h"
#include "app/console/session_input.h"
#include "core/answers/beforehand.h"
#include "core/session/protocol_progress.h"
#include "core/simulation/planned_session.h"
#include "core/wording/diagnosis_sentence.h"

namespace alidade::console {

void addPlanCommand(CLI::App& app, PlanRequest& request) {
  CLI::App* plan =
      app.add_subcommand("plan", "What a plan of readings can and cannot see, and what to add to it.");
  plan->add_option(
          "FILE", request.file,
          "Session with the rows to be read (*.alidade); - reads standard input. Rows without readings "
          "are thought to be read at their slider coordinate, else evenly spread")
      ->required();
  addEffectsOption(*plan, request.effects);
  plan->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runPlan(const PlanRequest& request) {
  Result<SessionInput> read = readSessionInput(request.file, &withPlannedReadings, request.effects);
  if (!read) return read.problem();
  SessionInput input = *std::move(read);
  const SessionEffort effort = effortOf(input.measurement, sightingMinutesOf(input.session));
  input.session = {};  // frees the memory of the rows
  const SessionFit fit = fitSession(input.measurement);
  const Result<std::vector<Finding>> findings = findingsBeforehand(input.measurement, fit);
  if (!findings) return findings.problem();
  const auto review = reviewPlan(input.measurement, fit);
  if (!review) return problemOf(review.problem());
  return request.json ? planJson(input.name, *review, *findings, input.measurement, input.digest)
                      : planText(input.name, *review, *findings, effort);
}

}  // namespace alidade::console
