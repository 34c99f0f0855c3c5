#include "app/console/commands/diagnose_command.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "app/console/diagnosis_text.h"
#include "app/console/session_input.h"
#include "core/answers/beforehand.h"
#include "core/answers/diagnosis_json.h"
#include "core/diagnosis/diagnose.h"
#include "core/effects/cause_ids.h"
#include "core/wording/diagnosis_fault.h"

namespace alidade::console {

void addDiagnoseCommand(CLI::App& app, DiagnoseRequest& request) {
  CLI::App* diagnose = app.add_subcommand(
      "diagnose", "Where model and readings disagree, what causes it, and how far the gap shrinks.");
  diagnose->add_option("FILE", request.file, "Session to diagnose (*.alidade); - reads standard input")
      ->required();
  diagnose
      ->add_option("--vertical-angle", request.verticalAngle,
                   "Take this relation of the vertical circle for the model, whatever the session says")
      ->check(CLI::IsMember({"exact", "planar"}));
  diagnose
      ->add_option("--without", request.without, "An effect not to be considered; may be given several times")
      ->check(CLI::IsMember(diagnosableEffects()));
  diagnose->add_flag("--with-reference", request.withReference,
                     "Weigh the causes with the reference intersection and its σ, too; Δd never");
  diagnose->add_option("--instrument", request.instrument,
                       "Take what this instrument record says (*.alidade-instrument), for this run");
  diagnose->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runDiagnose(const DiagnoseRequest& request) {
  Result<SessionInput> read = readSessionInput(request.file, request.instrument);
  if (!read) return read.problem();
  SessionInput input = *std::move(read);
  input.session = {};  // of no more use, and as long as its rows
  Measurement& measurement = input.measurement;
  if (!request.verticalAngle.empty())
    measurement.relation =
        request.verticalAngle == "planar" ? VerticalAngleRelation::Planar : VerticalAngleRelation::Exact;
  if (request.withReference && !measurement.sigmaReference)
    return Problem{
        "--with-reference: state acceptance.reference_intersection_mm and acceptance.sigma_reference_mm in "
        "the session, or leave it out",
        {.field = "acceptance.sigma_reference_mm"}};
  const SessionFit fit = fitSession(measurement);
  const Result<std::vector<Finding>> findings = findingsBeforehand(measurement, fit);
  if (!findings) return findings.problem();
  const auto diagnosis =
      diagnose(measurement, fit,
               {.without = request.without, .withReference = request.withReference, .withAttainable = true});
  if (!diagnosis) return problemOf(diagnosis.problem());
  return request.json ? diagnosisJson(input.name, *diagnosis, *findings)
                      : diagnosisText(input.name, *diagnosis, *findings);
}

}  // namespace alidade::console
