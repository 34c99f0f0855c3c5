#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli protocol`.
struct ProtocolRequest {
  std::string file;                       ///< a path, or - for standard input
  std::string protocol;                   ///< a name, or a file; empty: the session's protocol
  std::string order;                      ///< "listed" or "by-worth"; empty: as the protocol says
  std::optional<double> uncertainty;      ///< U of Δd, mm, to be reached; needs an order by worth
  std::string saveSession, saveTemplate;  ///< paths; empty: not requested
  bool json = false;
};

/// Adds `protocol FILE [--template NAME|FILE] [--order ORDER] [--uncertainty MM] [--out FILE]
/// [--save-template FILE] [--json]`, which fills in `request`.
void addProtocolCommand(CLI::App& app, ProtocolRequest& request);

/// The next and the remaining sightings, the sightings to repeat, and when the readings are enough. Fails if
/// the session or the protocol is unusable, or if a requested file cannot be written.
Result<std::string> runProtocol(const ProtocolRequest& request);

}  // namespace alidade::console
