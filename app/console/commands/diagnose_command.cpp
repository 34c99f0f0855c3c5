#include "app/console/commands/diagnose_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "app/console/channels.h"
#include "app/console/commands/shared_options.h"
#include "app/console/diagnosis_text.h"
#include "app/console/output_file.h"
#include "app/console/own_effect_files.h"
#include "app/console/series_text.h"
#include "app/console/session_files.h"
#include "app/console/session_input.h"
#include "core/answers/beforehand.h"
#include "core/answers/diagnosis_json.h"
#include "core/answers/series_json.h"
#include "core/base/list_text.h"
#include "core/base/threads.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/kept_form.h"
#include "core/effects/cause_ids.h"
#include "core/evaluation/gap.h"
#include "core/series/shared_causes/diagnose_series.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/series_words.h"

namespace alidade::console {

namespace {

void takeRelation(const DiagnoseRequest& request, Measurement& measurement) {
  if (!request.verticalAngle.empty())
    measurement.relation =
        request.verticalAngle == "planar" ? VerticalAngleRelation::Planar : VerticalAngleRelation::Exact;
}

std::optional<Problem> keep(const OwnEffect& effect, const DiagnoseRequest& request) {
  return writeOutputs({{"--keep-form", request.keepForm, writeOwnEffect(effect)}}, request.files);
}

/// Writes the first form of the diagnosis to the file of `--keep-form`, as an effect of the user's own.
std::optional<Problem> keepForm(const DiagnoseRequest& request, const Diagnosis& diagnosis,
                                const Session& session) {
  if (diagnosis.forms.empty()) return Problem{"--keep-form: no form was found in these readings"};
  return keep(ownEffectOf(diagnosis.forms.front(), session), request);
}

std::optional<Problem> keepOffered(const DiagnoseRequest& request, const SeriesDiagnosis& series) {
  if (series.offered.empty())
    return Problem{"--keep-form: no three sessions of one device or instrument show the same form"};
  return keep(series.offered.front().effect, request);
}

/// The name of the series: the name of its folder, or the number of its sessions.
std::string seriesName(const std::vector<std::string>& named, std::size_t sessions) {
  if (named.size() == 1) {
    const std::filesystem::path folder = std::filesystem::path(named.front()).lexically_normal();
    const std::string name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
    if (!name.empty() && name != ".") return wellFormed(name);
  }
  return "Series of " + counted(sessions, "session");
}

/// Accepts the ids of the catalogue, which the help lists. Also accepts any id with the prefix of the user's
/// own effects: only the session can tell whether the effect exists.
CLI::Validator effectCheck() {
  CLI::Validator check = CLI::IsMember(diagnosableEffects());
  check.operation([isOfCatalogue = check](std::string& id) {
    return id.starts_with(ownPrefix) ? std::string() : isOfCatalogue(id);
  });
  return check;
}

std::function<void(std::size_t, std::size_t)> progressLine(bool wanted) {
  return [lines = ProgressLines(wanted)](std::size_t done, std::size_t all) mutable {
    if (lines.isDue())
      notify("alidade-cli", std::to_string(100 * done / std::max<std::size_t>(all, 1)) + " % done");
  };
}

}  // namespace

void addDiagnoseCommand(CLI::App& app, DiagnoseRequest& request) {
  CLI::App* diagnose = app.add_subcommand(
      "diagnose", "Where model and readings disagree, what causes it, and how far the gap shrinks.");
  diagnose
      ->add_option(
          "FILE", request.files,
          "Session to diagnose (*.alidade); - reads standard input. Several, or a folder of them, are a "
          "series: what they share is sought in all of them together")
      ->required();
  diagnose->add_flag("--each", request.each,
                     "Diagnose each of several files, or of a folder of them, by itself");
  diagnose
      ->add_option("--vertical-angle", request.verticalAngle,
                   "Take this relation of the vertical circle for the model, whatever the session says")
      ->check(CLI::IsMember({"exact", "planar"}));
  diagnose
      ->add_option("--without", request.without, "An effect not to be considered; may be given several times")
      ->check(effectCheck());
  diagnose->add_flag("--with-reference", request.withReference,
                     "Weigh the causes with the reference intersection and its σ, too; Δd never");
  diagnose->add_option("--instrument", request.instrument,
                       "Take what this instrument record says (*.alidade-instrument), for this run");
  addEffectsOption(*diagnose, request.effects);
  diagnose->add_option("--keep-form", request.keepForm,
                       "Write the first form found as an effect of this device or instrument "
                       "(*.alidade-effect); of a series, the form that most sessions show, if three do");
  addBatchOptions(*diagnose, request.batch);
}

Result<std::string> runDiagnose(const DiagnoseRequest& request, const std::string& file) {
  Result<SessionInput> read = readSessionInput(file, request.instrument, request.effects);
  if (!read) return read.problem();
  SessionInput input = *std::move(read);
  if (request.batch.json) input.session.positions.clear();  // frees memory; only the text needs the rows
  Measurement& measurement = input.measurement;
  takeRelation(request, measurement);
  if (request.withReference && !measurement.sigmaReference)
    return Problem{
        "--with-reference: state acceptance.reference_intersection_mm and acceptance.sigma_reference_mm in "
        "the session, or leave it out",
        {.field = "acceptance.sigma_reference_mm"}};
  SessionFit fit = fitSession(measurement);
  const Result<std::vector<Finding>> findings = findingsBeforehand(measurement, fit);
  if (!findings) return findings.problem();
  auto diagnosis =
      diagnose(measurement, fit,
               {.without = request.without, .withReference = request.withReference, .withAttainable = true});
  if (!diagnosis) return problemOf(diagnosis.problem());
  if (!request.keepForm.empty())
    if (auto problem = keepForm(request, *diagnosis, input.session)) return *std::move(problem);
  if (request.batch.json) return diagnosisJson(input.name, *diagnosis, *findings, input.digest);
  auto evaluation = std::make_shared<Evaluation>();
  evaluation->session = std::move(input.session);
  evaluation->examined.measurement = std::move(measurement);
  evaluation->fit = std::move(fit);
  return diagnosisText(input.name, gapOf(std::move(evaluation), *std::move(diagnosis)), *findings);
}

int giveSeries(const DiagnoseRequest& request) {
  if (request.withReference)
    return refuse("--with-reference", "a series is not weighed with references: leave it out, or say --each");
  const SessionFiles listed = sessionFilesOf(request.files);
  for (const std::string& path : listed.again) notify(inputName(path), "named again: it counts once");
  const std::size_t threads = threadsOrAll(request.batch.threads);
  std::vector<std::optional<Result<SeriesSession>>> read(listed.files.size());
  doEach(threads, listed.files.size(), [&](std::size_t i) {
    const ListedFile& file = listed.files[i];
    if (file.problem) {
      read[i] = Result<SeriesSession>(*file.problem);
      return;
    }
    Result<SessionInput> found = readSessionInput(file.path, request.instrument, request.effects);
    if (!found) {
      read[i] = Result<SeriesSession>(found.problem());
      return;
    }
    SessionInput input = *std::move(found);
    takeRelation(request, input.measurement);
    SeriesSession session = seriesSession(input.name, input.session, std::move(input.measurement));
    session.file = inputName(file.path);
    read[i] = Result<SeriesSession>(std::move(session));
  });
  int exitCode = Done;
  std::vector<SeriesSession> sessions;
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (*read[i]) {
      sessions.push_back(**std::move(read[i]));
      paths.push_back(listed.files[i].path);
    } else {
      exitCode = refuse(inputName(listed.files[i].path), read[i]->problem().text());
    }
  }
  if (sessions.empty())
    return exitCode == Done ? refuse("alidade-cli", "there is no session to diagnose") : exitCode;
  const auto outcome = diagnoseSeries(
      sessions,
      {.without = request.without, .threads = threads, .progress = progressLine(request.batch.progress)});
  if (!outcome) return refuse("alidade-cli", problemOf(outcome.problem()).text());
  for (const auto& [copy, first] : outcome->copies)
    notify(inputName(paths[copy]), copyReason(inputName(paths[copy]), inputName(paths[first])));
  for (const auto& [index, fault] : outcome->unusable)
    exitCode = refuse(inputName(paths[index]), problemOf(fault).text());
  if (!request.keepForm.empty())
    if (const auto problem = keepOffered(request, outcome->diagnosis))
      return refuse("alidade-cli", problem->text());
  const std::string name = seriesName(request.files, outcome->diagnosis.sessions.size());
  const int written = writeResult(request.batch.json ? seriesJson(name, outcome->diagnosis)
                                                     : seriesText(name, outcome->diagnosis));
  return written == Done ? exitCode : written;
}

}  // namespace alidade::console
