#include "app/console/commands/protocol_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/console/commands/option_checks.h"
#include "app/console/guidance_text.h"
#include "app/console/output_file.h"
#include "app/console/session_input.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/plan_review.h"
#include "core/guidance/advised_protocol.h"
#include "core/session/entry.h"
#include "core/session/protocol_progress.h"
#include "core/session/session_file.h"
#include "core/simulation/planned_session.h"
#include "core/simulation/protocol.h"

namespace alidade::console {

namespace {

constexpr const char* fromRows = "rows";
constexpr const char* fromPlan = "plan";
constexpr const char *orderListed = "listed", *orderByWorth = "by-worth";

std::string templateNames() {
  std::vector<std::string> names;
  for (const Protocol& protocol : namedProtocols()) names.push_back(protocol.name);
  return listed(names);
}

/// The protocol of the session's rows. Fails if there are no rows, or more than a protocol holds.
Result<SightingProtocol> ofRows(const Session& session, const std::string& option) {
  SightingProtocol own = protocolFromRows(session);
  if (!own.positions.empty()) return own;
  const bool hasRows = std::ranges::any_of(
      session.positions, [](const Position& position) { return !position.readings.empty(); });
  return Problem{option +
                 (hasRows ? ": the rows are no protocol, which holds at most " +
                                std::to_string(mostSightings) + " sightings"
                          : std::string(": the session has no rows")) +
                 "; name a template, such as full"};
}

/// The protocol of the session's rows, extended by the first advice of `plan` that a protocol can express.
Result<SightingProtocol> advisedFor(const Session& session) {
  Result<SightingProtocol> own = ofRows(session, "--template plan");
  if (!own) return own;
  const Session planned = withPlannedReadings(session);
  const Examined examined = examine(planned);
  if (!examined.measurement)
    return examined.problems.empty() ? Problem{"--template plan: the session cannot be planned"}
                                     : examined.problems.front();
  const auto review = reviewPlan(*examined.measurement);
  if (!review) return own;
  for (const PlanAdvice& advice : review->advice)
    if (std::ranges::all_of(advice.measures, isForProtocol)) {
      SightingProtocol advised = withMeasures(*own, advice.measures);
      return advised.positions.empty() ? own : advised;
    }
  return own;
}

/// The file named by --template; empty if --template names no file.
std::string templateFile(const ProtocolRequest& request) {
  const std::string& named = request.protocol;
  return named == fromRows || named == fromPlan || templateNamed(named) ? std::string() : named;
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
  if (request.protocol == fromRows) return ofRows(session, "--template rows");
  if (request.protocol == fromPlan) return advisedFor(session);
  if (auto named = templateNamed(request.protocol)) return *std::move(named);
  Result<SightingProtocol> loaded = loadProtocol(request.protocol);
  if (!loaded) return Problem{"--template " + visibleText(request.protocol) + ": " + loaded.problem().text()};
  return loaded;
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
  protocol
      ->add_option("--order", request.order,
                   "The next sighting: listed (in the order of the protocol) or by-worth (the most "
                   "informative for its minutes)")
      ->check(CLI::IsMember({orderListed, orderByWorth}));
  protocol
      ->add_option("--uncertainty", request.uncertainty,
                   "The sightings that reach this U of Δd, mm, in the fewest minutes; by-worth")
      ->check(numberFrom(1e-4, 1000));
  protocol->add_option("--out", request.saveSession,
                       "Write the session with the protocol in it to this file");
  protocol->add_option("--save-template", request.saveTemplate,
                       "Write the protocol to this file (*.alidade-protocol)");
  protocol->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runProtocol(const ProtocolRequest& request) {
  const Result<SessionRead> read = readSessionOf(request.file);
  if (!read) return read.problem();
  const Session* const session = &read->session;
  Result<SightingProtocol> wanted = wantedProtocol(request, *session);
  if (!wanted) return wanted.problem();
  SightingProtocol protocol = *std::move(wanted);
  if (request.order == orderByWorth) protocol = openOrder(std::move(protocol));
  if (request.order == orderListed) protocol = listedOrder(std::move(protocol));
  if (request.uncertainty && !protocol.isByWorth)
    return Problem{"--uncertainty chooses sightings: give --order by-worth, too"};
  std::vector<OutputFile> outputs;
  if (!request.saveSession.empty()) {
    Session following = *session;
    following.protocol = protocolText(protocol);
    outputs.push_back({"--out", request.saveSession, writeSession(following)});
  }
  if (!request.saveTemplate.empty())
    outputs.push_back({"--save-template", request.saveTemplate, writeProtocol(protocol)});
  if (auto problem = writeOutputs(outputs, {request.file, templateFile(request)})) return *std::move(problem);
  const Guidance guidance = guidanceOf(*session, protocol, request.uncertainty);
  const std::string name = nameOf(*session, request.file);
  return request.json ? guidanceJson(name, guidance, read->digest)
                      : guidanceText(name, guidance, circleUnitOf(*session));
}

}  // namespace alidade::console
