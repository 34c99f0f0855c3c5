#include "app/console/commands/protocol_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/console/guidance_text.h"
#include "app/console/output_file.h"
#include "app/console/session_input.h"
#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/two_faces.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/plan_review.h"
#include "core/guidance/advised_protocol.h"
#include "core/guidance/forecast.h"
#include "core/session/entry.h"
#include "core/session/session_file.h"
#include "core/simulation/planned_session.h"
#include "core/simulation/protocol_template.h"

namespace alidade::console {

namespace {

constexpr const char* fromRows = "rows";
constexpr const char* fromPlan = "plan";

std::string templateNames() {
  std::vector<std::string> names;
  for (const Protocol& protocol : namedProtocols()) names.push_back(protocol.name);
  return listed(names);
}

/// The session's rows, with what `alidade-cli plan` advises before all else.
Result<SightingProtocol> advisedFor(const Session& session) {
  SightingProtocol own = protocolFromRows(session);
  if (own.positions.empty())
    return Problem{"--template plan: the session has no rows to plan from; name a template, such as full"};
  const Session planned = withPlannedReadings(session);
  const Examined examined = examine(planned);
  if (!examined.measurement)
    return examined.problems.empty() ? Problem{"--template plan: the session cannot be planned"}
                                     : examined.problems.front();
  const auto review = reviewPlan(*examined.measurement);
  if (!review) return own;
  for (const PlanAdvice& advice : review->advice)
    if (std::all_of(advice.measures.begin(), advice.measures.end(), isForProtocol))
      return withMeasures(std::move(own), advice.measures);
  return own;
}

Result<SightingProtocol> wantedProtocol(const ProtocolRequest& request, const Session& session) {
  if (request.protocol.empty()) {
    auto own = protocolOf(session);
    if (!own) return own.problem();
    if (!*own)
      return Problem{"the session follows no protocol: name one by --template (" + templateNames() +
                     ", rows, plan, or a file)"};
    return **std::move(own);
  }
  if (request.protocol == fromRows) {
    SightingProtocol own = protocolFromRows(session);
    if (own.positions.empty()) return Problem{"--template rows: the session has no rows"};
    return own;
  }
  if (request.protocol == fromPlan) return advisedFor(session);
  if (auto named = templateNamed(request.protocol)) return *std::move(named);
  Result<SightingProtocol> loaded = loadProtocol(request.protocol);
  if (!loaded) return Problem{"--template " + visibleText(request.protocol) + ": " + loaded.problem().text()};
  return loaded;
}

Guidance guidanceOf(const Session& session, SightingProtocol protocol) {
  Guidance guidance;
  guidance.progress = progressOf(session, protocol);
  guidance.protocol = std::move(protocol);
  guidance.expected.resize(guidance.progress.sightings.size());
  const Examined examined = examine(session);
  if (!examined.measurement) return guidance;
  const Measurement& measurement = *examined.measurement;
  const SessionFit fit = fitSession(measurement);
  guidance.expected = forecast(measurement, fit, guidance.protocol, guidance.progress);
  const std::vector<Suspect> suspects =
      fit.arcs.empty() ? std::vector<Suspect>() : findSuspects(session, measurement, fit);
  const std::optional<TwoFaces> faces = compareFaces(measurement);
  guidance.repeats = repeatsOf({measurement, fit, faces ? &*faces : nullptr, suspects}, guidance.progress);
  std::optional<Diagnosis> diagnosis;
  if (fit.intersection)
    if (auto found = diagnose(measurement, fit)) diagnosis = *std::move(found);
  guidance.outlook =
      outlookOf(measurement, fit, diagnosis ? &*diagnosis : nullptr, guidance.protocol, guidance.progress);
  return guidance;
}

}  // namespace

void addProtocolCommand(CLI::App& app, ProtocolRequest& request) {
  CLI::App* protocol = app.add_subcommand(
      "protocol",
      "How far a session is in its protocol: what is next, left, to be repeated, and when it is enough.");
  protocol->add_option("FILE", request.file, "Session (*.alidade); - reads standard input")->required();
  protocol->add_option(
      "--template", request.protocol,
      "Follow this protocol, whatever the session says: a file (*.alidade-protocol), a name (" +
          templateNames() + "), rows (as the session has them) or plan (as plan advises)");
  protocol->add_option("--out", request.saveSession,
                       "Write the session with the protocol in it to this file");
  protocol->add_option("--save-template", request.saveTemplate,
                       "Write the protocol to this file (*.alidade-protocol)");
  protocol->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runProtocol(const ProtocolRequest& request) {
  const Result<Session> session = readSessionOf(request.file);
  if (!session) return session.problem();
  const Result<SightingProtocol> protocol = wantedProtocol(request, *session);
  if (!protocol) return protocol.problem();
  std::vector<OutputFile> outputs;
  if (!request.saveSession.empty()) {
    Session following = *session;
    following.protocol = protocolText(*protocol);
    outputs.push_back({"--out", request.saveSession, writeSession(following)});
  }
  if (!request.saveTemplate.empty())
    outputs.push_back({"--save-template", request.saveTemplate, writeProtocol(*protocol)});
  if (auto problem = writeOutputs(outputs, request.file)) return *std::move(problem);
  const Guidance guidance = guidanceOf(*session, *protocol);
  const std::string name = nameOf(*session, request.file);
  return request.json ? guidanceJson(name, guidance) : guidanceText(name, guidance, circleUnitOf(*session));
}

}  // namespace alidade::console
