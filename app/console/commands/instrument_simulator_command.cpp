#include "app/console/commands/instrument_simulator_command.h"

#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <utility>

#include "app/console/channels.h"
#include "app/console/commands/option_checks.h"
#include "app/console/pseudo_terminal.h"
#include "app/console/session_input.h"
#include "core/connection/simulated_instrument.h"
#include "core/simulation/protocol.h"
#include "core/simulation/simulate.h"

namespace alidade::console {

namespace {

constexpr int turnMs = 20;  // milliseconds between two polls of the port
constexpr double longestPauseS = 3600, largestNoiseArcsec = 3600;
constexpr int mostSightings = 1'000'000;

constexpr std::array<std::pair<const char*, char>, 3> units = {
    {{"gon", '2'}, {"degrees", '3'}, {"dms", '4'}}};
constexpr std::array<const char*, 4> corrections = {"inclination", "standing_axis", "collimation",
                                                    "tilting_axis"};

volatile std::sig_atomic_t isStopped = 0;

void stopSpeaking(int) {
  isStopped = 1;
}

template <class Range, class Name>
std::vector<std::string> namesOf(const Range& range, Name name) {
  std::vector<std::string> names;
  for (const auto& one : range) names.emplace_back(name(one));
  return names;
}

std::vector<std::string> faultNames() {
  return namesOf(instrumentFaults, [](const InstrumentFaultName& fault) { return fault.name; });
}

Result<Session> sessionOf(const SimulatorRequest& request) {
  if (!request.session.empty()) {
    const Result<SessionRead> read = readSessionOf(request.session);
    return read ? Result<Session>(read->session) : Result<Session>(read.problem());
  }
  return simulate(*protocolByName(request.plan), drawTruth(request.seed), request.seed);
}

SimulatedOptions optionsOf(const SimulatorRequest& request, const Session& session) {
  SimulatedOptions options;
  options.protocol = request.protocol == "gsi" ? InstrumentProtocol::Gsi : InstrumentProtocol::GeoCom;
  options.sightings = sightingsOf(session, Angle::fromArcseconds(request.noise), request.seed);
  for (const std::string& name : request.faults)
    for (const InstrumentFaultName& fault : instrumentFaults)
      if (fault.name == name) options.faults.push_back(fault.fault);
  options.faultEvery = static_cast<std::size_t>(request.faultEvery.value_or(5));
  options.isWide = request.width == 16;
  options.hasChecksums = request.hasChecksums;
  for (const auto& [name, unit] : units)
    if (request.unit == name) options.gsiUnit = unit;
  for (std::size_t i = 0; i < corrections.size(); ++i)
    options.corrections.at(i) = std::find(request.uncorrected.begin(), request.uncorrected.end(),
                                          corrections.at(i)) == request.uncorrected.end();
  return options;
}

Milliseconds clockMs() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

/// The key REC, pressed by Enter on standard input or at regular intervals.
class RecordKey {
 public:
  explicit RecordKey(double everyS)
      : m_every(static_cast<Milliseconds>(everyS * 1000)), m_next(clockMs() + m_every) {}

  bool isPressed(bool hasInput) {
    if (m_every > 0) {
      if (clockMs() < m_next) return false;
      m_next = clockMs() + m_every;
      return true;
    }
    if (!hasInput || !m_isOpen) return false;
    char c = 0;
    if (::read(STDIN_FILENO, &c, 1) <= 0) m_isOpen = false;
    return m_isOpen && c == '\n';
  }
  /// True if Enter on standard input presses the key.
  bool isTyped() const { return m_every == 0 && m_isOpen; }

 private:
  Milliseconds m_every, m_next;
  bool m_isOpen = true;
};

void speak(const PseudoTerminal& line, SimulatedInstrument& instrument, const SimulatorRequest& request) {
  RecordKey key(request.every);
  int presses = 0;  ///< presses waiting for the acknowledgement of the previous block
  while (isStopped == 0 && !(request.endsWhenDone && instrument.isDone())) {
    std::array<pollfd, 2> ends = {pollfd{line.descriptor(), POLLIN, 0}, pollfd{STDIN_FILENO, POLLIN, 0}};
    poll(ends.data(), key.isTyped() ? 2 : 1, turnMs);
    const bool hasInput = key.isTyped() && (ends[1].revents & (POLLIN | POLLHUP)) != 0;
    std::string sent = instrument.receive(line.read());
    presses += key.isPressed(hasInput) ? 1 : 0;
    if (presses > 0 && !instrument.isWaiting()) {
      --presses;
      sent += instrument.record(clockMs());
    }
    sent += instrument.tick(clockMs());
    if (!line.write(sent))
      notify("alidade-cli instrument-simulator", "nobody reads the line: its buffer is full");
  }
}

}  // namespace

void addSimulatorCommand(CLI::App& app, SimulatorRequest& request) {
  CLI::App* simulator = app.add_subcommand("instrument-simulator",
                                           "An instrument to try a connection with: prints the path of a "
                                           "line and speaks there until it is stopped.");
  simulator->add_option("file", request.session,
                        "Session whose readings it sends; if not given, one is simulated");
  simulator->add_option("--protocol", request.protocol, "geocom or gsi")
      ->check(CLI::IsMember({"geocom", "gsi"}))
      ->capture_default_str();
  simulator
      ->add_option("--plan", request.plan, "Plan of readings that are simulated, as `simulate --protocol`")
      ->check(
          CLI::IsMember(namesOf(namedProtocols(), [](const Protocol& protocol) { return protocol.name; })))
      ->capture_default_str();
  simulator->add_option("--seed", request.seed, "Whole number that fixes everything drawn")
      ->check(seedCheck())
      ->capture_default_str();
  simulator->add_option("--noise", request.noise, "σ added to each circle reading, arcsec")
      ->check(numberFrom(0, largestNoiseArcsec));
  simulator
      ->add_option("--fault", request.faults,
                   "garbage, cut, silent, twice, busy, wrong, other-face, turned, again, not-vouched-for, "
                   "other-serial or wrong-checksum; several in turn")
      ->check(CLI::IsMember(faultNames()))
      ->take_all()
      ->expected(1);
  simulator->add_option("--fault-every", request.faultEvery, "So many sightings have one fault; else 5")
      ->check(wholeFrom(1, mostSightings));
  simulator
      ->add_option("--every", request.every, "gsi: seconds between blocks; if not given, Enter records one")
      ->check(numberFrom(0, longestPauseS));
  simulator->add_option("--width", request.width, "gsi: digits of a word, 8 or 16")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  simulator->add_option("--unit", request.unit, "gsi: dms, degrees or gon")
      ->check(CLI::IsMember({"dms", "degrees", "gon"}))
      ->capture_default_str();
  simulator
      ->add_option(
          "--uncorrected", request.uncorrected,
          "geocom: inclination, standing_axis, collimation or tilting_axis is not corrected; several")
      ->check(CLI::IsMember(namesOf(corrections, [](const char* name) { return name; })))
      ->take_all()
      ->expected(1);
  simulator->add_flag("--checksums", request.hasChecksums, "geocom: answers have a check sum");
  simulator->add_flag("--until-told", request.endsWhenDone, "End once every reading is sent");
}

Result<std::string> runSimulator(const SimulatorRequest& request) {
  const Result<Session> session = sessionOf(request);
  if (!session) return session.problem();
  SimulatedInstrument instrument(optionsOf(request, *session));
  if (instrument.isDone()) return Problem{"has no readings that an instrument could send"};
  const Result<PseudoTerminal> line = PseudoTerminal::open();
  if (!line) return line.problem();
  if (writeResult(line->path() + "\n") != Done) return Problem{"the path of the line could not be printed"};
  std::signal(SIGINT, stopSpeaking);
  std::signal(SIGTERM, stopSpeaking);
  speak(*line, instrument, request);
  return "sent " + std::to_string(instrument.delivered()) + " sightings\n";
}

}  // namespace alidade::console
