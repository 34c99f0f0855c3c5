#include "app/console/commands/simulate_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/console/commands/option_checks.h"
#include "app/console/output_file.h"
#include "app/console/own_effect_files.h"
#include "app/console/session_input.h"
#include "core/base/number_text.h"
#include "core/base/visible_text.h"
#include "core/session/measurement.h"
#include "core/session/session_file.h"
#include "core/simulation/compensator_use.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"
#include "core/simulation/truth_text.h"

namespace alidade::console {

namespace {

constexpr double shortestMm = 1e-6, longestMm = 1e6, leastArcsec = 1e-6, largestArcsec = 3600;
constexpr int mostPoints = 100000, mostRounds = 1000;

/// An option with a number. Without the option, the number is drawn or has a default.
struct NumberOption {
  const char* name;
  std::optional<double> SimulateRequest::*value;
  double least, most;
  const char* help;
};

using Request = SimulateRequest;

constexpr NumberOption numberOptions[] = {
    {"--intersection", &Request::intersection, -longestMm, longestMm, "True Δd, mm; drawn if not given"},
    {"--centre-x", &Request::centreX, -longestMm, longestMm, "True Δx of both positions, mm"},
    {"--axis-height", &Request::axisHeight, -longestMm, longestMm, "True height of the axis, mm"},
    {"--radius", &Request::radius, shortestMm, longestMm, "True radius, mm"},
    {"--nominal-radius", &Request::nominalRadius, shortestMm, longestMm,
     "Nominal radius, mm; 400 if not given"},
    {"--distance", &Request::distance, shortestMm, longestMm,
     "True distance to the arc plane, mm; else 2405"},
    {"--sigma-distance", &Request::sigmaDistance, 0, longestMm - 1, "σ of the distance stated, mm; else 0"},
    {"--tolerance", &Request::tolerance, shortestMm, longestMm, "Tolerance of the intersection stated, mm"},
    {"--sigma", &Request::sigma, leastArcsec, largestArcsec - 1, "Stated σ of both circles, arcsec; else 2"},
    {"--sigma-zero", &Request::sigmaZero, 0, largestArcsec - 1,
     "σ of the pointing zeros, arcsec; else as --sigma"},
    {"--sigma-slider", &Request::sigmaSlider, leastArcsec, largestArcsec - 1,
     "σ of the slider, arcsec; else 5"},
    {"--sigma-compensator", &Request::sigmaCompensator, leastArcsec, largestArcsec - 1,
     "Setting accuracy of the compensator, arcsec; else 1"},
    {"--typing-step", &Request::typingStep, leastArcsec, largestArcsec,
     "Readings are rounded to this, arcsec; else 0.1"},
};

std::vector<std::string> protocolNames() {
  std::vector<std::string> names;
  for (const Protocol& protocol : namedProtocols()) names.push_back(protocol.name);
  return names;
}

std::string footer() {
  std::string text = "Protocols:\n";
  for (const Protocol& protocol : namedProtocols())
    text += "  " + protocol.name + ": " + protocol.description + "\n";
  return text + "Effects:\n" + effectNames() +
         "Where an effect has several sizes, one can be given by the last word of its name: "
         "plane_tilt.x=0.3.";
}

void addPlanOptions(CLI::App& simulate, SimulateRequest& request) {
  simulate.add_option("--seed", request.seed, "Whole number that fixes everything drawn")
      ->check(seedCheck())
      ->capture_default_str();
  simulate.add_option("--protocol", request.protocol, "Plan of readings")
      ->check(CLI::IsMember(protocolNames()))
      ->capture_default_str();
  simulate.add_option("--points", request.points, "Places of the slider over the protocol's range")
      ->check(wholeFrom(1, mostPoints));
  simulate.add_option("--rounds", request.rounds, "Rounds, there and back in turn")
      ->check(wholeFrom(1, mostRounds));
}

void setIf(double& value, const std::optional<double>& given) {
  if (given) value = *given;
}

void setIf(Angle& value, const std::optional<double>& arcseconds) {
  if (arcseconds) value = Angle::fromArcseconds(*arcseconds);
}

Truth truthOf(const SimulateRequest& request) {
  Truth truth = drawTruth(request.seed);
  truth.protocol = request.protocol;
  setIf(truth.intersection, request.intersection);
  setIf(truth.centreX, request.centreX);
  setIf(truth.axisHeight, request.axisHeight);
  setIf(truth.radius, request.radius);
  setIf(truth.distance, request.distance);
  setIf(truth.nominalRadius, request.nominalRadius);
  setIf(truth.sigmaDistance, request.sigmaDistance);
  setIf(truth.sigmaHorizontal, request.sigma);
  setIf(truth.sigmaVertical, request.sigma);
  setIf(truth.sigmaZero, request.sigmaZero ? request.sigmaZero : request.sigma);
  setIf(truth.sigmaSlider, request.sigmaSlider);
  setIf(truth.typingStep, request.typingStep);
  truth.sightsZerosInFull = request.zerosInFull;
  if (request.verticalCircle == "elevation") {
    truth.verticalCircle = VerticalCircle::Elevation;
    truth.verticalZero = Angle();
  }
  return truth;
}

/// The named protocol. If the request states a number of points, they are spread over the same range.
Protocol protocolOf(const SimulateRequest& request) {
  Protocol protocol = *protocolByName(request.protocol);
  if (request.rounds) protocol.rounds = *request.rounds;
  if (!request.points) return protocol;
  const Angle range = protocol.step * (protocol.points - 1);
  protocol.points = *request.points;
  protocol.step = range * (1.0 / std::max(1, protocol.points - 1));
  return protocol;
}

/// Simulates the session. If the compensator is on, removes the tilts of the vertical axis from `truth`.
Result<Session> sessionOf(const SimulateRequest& request, Truth& truth) {
  const Angle sigma = Angle::fromArcseconds(request.sigmaCompensator.value_or(1));
  const bool isOn = request.compensator == "on";
  const Protocol protocol = protocolOf(request);
  Result<Session> simulated =
      simulate(protocol, isOn ? leftByCompensator(truth, sigma, request.seed) : truth, request.seed);
  if (!simulated || request.compensator.empty()) return simulated;
  Session session = *std::move(simulated);
  const bool isMeasured = request.compensator == "measured";
  const CompensatorUse unlessOn = isMeasured ? CompensatorUse::Measured : CompensatorUse::Off;
  stateCompensator(session, truth, isOn ? CompensatorUse::On : unlessOn, sigma, request.seed);
  if (isOn)
    std::erase_if(truth.effects, [](const TrueSize& size) {
      return size.term == ErrorTerm::VerticalAxisTiltX || size.term == ErrorTerm::VerticalAxisTiltZ;
    });
  return session;
}

}  // namespace

void addSimulateCommand(CLI::App& app, SimulateRequest& request) {
  CLI::App* simulate =
      app.add_subcommand("simulate", "A session from a known truth; the truth is kept in its own file.");
  simulate->add_option("--out", request.out, "Session file to write (*.alidade)")->required();
  simulate->add_option("--truth", request.truth, "Truth file to write (JSON)")->required();
  simulate->add_option("--title", request.title, "Title of the session")->check(textCheck());
  simulate->add_option("--instrument", request.instrument,
                       "Let the session take this instrument record (*.alidade-instrument)");
  simulate->add_option("--notes", request.notes, "Notes of the session")->check(textCheck());
  simulate->add_option("--measured-on", request.measuredOn, "Date that the session states")
      ->check(
          [](const std::string& date) { return entryProblem(Session(), "measured_on", date).value_or(""); });
  simulate->add_option("--device-serial", request.deviceSerial, "Serial number of the device")
      ->check(textCheck());
  simulate->add_option("--instrument-serial", request.instrumentSerial, "Serial number of the instrument")
      ->check(textCheck());
  addPlanOptions(*simulate, request);
  simulate->add_option("--effect", request.effects, "NAME=VALUE of an effect to put in; may be repeated")
      ->take_all()
      ->expected(1);
  simulate
      ->add_option("--effects", request.ownEffects,
                   "Effects of your own (*.alidade-effect, or a folder of them), to put in as "
                   "--effect own:NAME=VALUE; the session does not state them")
      ->take_all()
      ->expected(1);
  for (const NumberOption& option : numberOptions)
    simulate->add_option(option.name, request.*option.value, option.help)
        ->check(numberFrom(option.least, option.most));
  simulate->add_option("--vertical-circle", request.verticalCircle, "zenith or elevation")
      ->check(CLI::IsMember({"zenith", "elevation"}))
      ->capture_default_str();
  simulate->add_flag("--zeros-in-full", request.zerosInFull,
                     "Sight each pointing zero in both faces, before and after its position");
  simulate
      ->add_option(
          "--compensator", request.compensator,
          "on: the tilt of the vertical axis is taken off; measured: its tilts are stated; off: it is "
          "stated that nothing was corrected")
      ->check(CLI::IsMember({"on", "measured", "off"}));
  simulate->footer(footer());
}

Result<std::string> runSimulate(const SimulateRequest& request) {
  Truth truth = truthOf(request);
  const Result<std::vector<OwnEffect>> own = ownEffectsIn(request.ownEffects);
  if (!own) return own.problem();
  std::vector<Problem> problems;
  truth.own = examineOwnEffects(*own, problems);
  if (!problems.empty()) return Problem{"--effects: " + problems.front().text()};
  for (const std::string& effect : request.effects)
    if (auto problem = addEffect(truth, effect)) return *std::move(problem);
  Result<Session> simulated = sessionOf(request, truth);
  if (!simulated) return simulated.problem();
  Session session = *std::move(simulated);
  if (!request.title.empty()) session.title = request.title;
  session.notes = request.notes;
  session.measuredOn = request.measuredOn;
  session.device.serial = request.deviceSerial;
  session.instrument.serial = request.instrumentSerial;
  if (!request.instrument.empty())
    if (auto problem = addRecord(session, request.instrument)) return *std::move(problem);
  if (request.tolerance) session.acceptance.toleranceMm = shortestText(*request.tolerance);
  const std::string id = wellFormed(std::filesystem::path(request.out).stem().string());
  if (auto problem = writeOutputs(
          {{"--out", request.out, writeSession(session)}, {"--truth", request.truth, truthJson(id, truth)}},
          {request.instrument}))
    return *std::move(problem);
  std::size_t rows = 0;
  for (const Position& position : session.positions) rows += position.readings.size();
  return visibleText(request.out) + ": " + std::to_string(rows) + " rows by protocol " + request.protocol +
         "; the truth is in " + visibleText(request.truth) + "\n";
}

}  // namespace alidade::console
