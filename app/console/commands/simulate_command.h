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

/// What `alidade-cli simulate` was asked. What is not given of the truth is drawn from the seed.
struct SimulateRequest {
  std::string out, truth;                      ///< files to write
  std::string title, notes;                    ///< of the session; empty: named after the seed, and none
  std::string measuredOn;                      ///< date that it states
  std::string deviceSerial, instrumentSerial;  ///< that it states
  std::uint64_t seed = 1;
  std::string protocol = "paper";
  std::vector<std::string> effects;
  std::optional<int> points, rounds;
  std::optional<double> intersection, centreX, axisHeight, radius, distance, nominalRadius;  ///< mm
  std::optional<double> tolerance;                                                           ///< mm
  std::optional<double> sigmaDistance;                                                       ///< mm
  std::optional<double> sigma, sigmaZero, sigmaSlider, typingStep;                           ///< arcseconds
  std::string verticalCircle = "zenith";  ///< or "elevation"
  std::string instrument;                 ///< path of an instrument record; empty: none
  bool zerosInFull = false;
  std::string compensator;                 ///< "off", "measured" or "on"; empty: the session does not say
  std::optional<double> sigmaCompensator;  ///< arcseconds
};

/// Adds `simulate --out FILE --truth FILE [--seed N] [--effect NAME=VALUE]… [--protocol NAME] …`, which fills
/// in `request`.
void addSimulateCommand(CLI::App& app, SimulateRequest& request);

/// Writes the session and its truth, and answers with a line that says what was written. Fails where the
/// request cannot be carried out or a file cannot be written.
Result<std::string> runSimulate(const SimulateRequest& request);

}  // namespace alidade::console
