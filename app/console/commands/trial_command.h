#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli trial`.
struct TrialRequest {
  std::size_t count = 100;
  std::size_t series = 0;  ///< number of series of sessions; 0: single sessions
  std::uint64_t seed = 1;
  std::string protocol;              ///< empty: drawn
  std::string folder;                ///< folder of existing trials; empty: trials are drawn
  std::vector<std::string> effects;  ///< files of own effects that are drawn, too
  bool withheld = false;
  bool adaptive = false;    ///< whether to compare the order by worth with the protocol's order
  std::size_t two = 0;      ///< number of additional sessions with two effects; needs `adaptive`
  std::size_t unknown = 0;  ///< number of additional sessions with an uncatalogued effect; needs `adaptive`
  std::size_t clean = 0;    ///< number of additional sessions without an effect; needs `adaptive`
  unsigned threads = 0;
  bool json = false;
  bool csv = false;  ///< whether to print the curves of both orders; needs `adaptive`
};

/// Adds `trial [--count N | --series N] [--seed N] [--protocol NAME] [--score DIR] [--effects FILE]…
/// [--withheld] [--adaptive [--two N] [--unknown N] [--clean N] [--csv]] [--threads N] [--json]`, which fills
/// in `request`.
void addTrialCommand(CLI::App& app, TrialRequest& request);

/// The scores as text or JSON. Fails if a trial cannot be read or diagnosed.
Result<std::string> runTrial(const TrialRequest& request);

}  // namespace alidade::console
