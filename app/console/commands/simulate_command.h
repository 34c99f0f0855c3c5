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

/// The arguments of `alidade-cli simulate`. Missing parts of the truth are drawn from the seed.
struct SimulateRequest {
  std::string out, truth;                      ///< files to write
  std::string title, notes;                    ///< of the session; an empty title is made from the seed
  std::string measuredOn;                      ///< date stated in the session
  std::string deviceSerial, instrumentSerial;  ///< stated in the session
  std::uint64_t seed = 1;
  std::string protocol = "paper";
  std::vector<std::string> effects;
  std::vector<std::string> ownEffects;  ///< files and folders of effects of the user's own
  std::optional<int> points, rounds;
  std::optional<double> intersection, centreX, axisHeight, radius, distance, nominalRadius;  ///< mm
  std::optional<double> tolerance;                                                           ///< mm
  std::optional<double> sigmaDistance;                                                       ///< mm
  std::optional<double> sigma, sigmaZero, sigmaSlider, typingStep;                           ///< arcseconds
  std::string verticalCircle = "zenith";  ///< or "elevation"
  std::string instrument;                 ///< path of an instrument record; empty: none
  bool zerosInFull = false;
  std::string compensator;                 ///< "off", "measured" or "on"; empty: not stated in the session
  std::optional<double> sigmaCompensator;  ///< arcseconds
};

/// Adds `simulate --out FILE --truth FILE [--seed N] [--effect NAME=VALUE]… [--protocol NAME] …`, which fills
/// in `request`.
void addSimulateCommand(CLI::App& app, SimulateRequest& request);

/// Writes the session and its truth; returns a line on what was written. Fails if the request is impossible
/// or a file cannot be written.
Result<std::string> runSimulate(const SimulateRequest& request);

}  // namespace alidade::console
