#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

struct SimulatorRequest {
  std::string session;  ///< empty: a simulated session
  std::string protocol = "geocom";
  std::string plan = "full";
  std::uint64_t seed = 1;
  double noise = 0;  ///< arcsec
  std::vector<std::string> faults;
  std::optional<int> faultEvery;
  double every = 0;  ///< interval at which the key REC is pressed, s; 0: Enter presses it
  int width = 16;
  std::string unit = "dms";
  std::vector<std::string> uncorrected;
  bool hasChecksums = false;
  bool endsWhenDone = false;
};

void addSimulatorCommand(CLI::App& app, SimulatorRequest& request);

/// Prints the path of the port, then serves the port until stopped, or with `endsWhenDone` until all is sent.
Result<std::string> runSimulator(const SimulatorRequest& request);

}  // namespace alidade::console
