#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/problem.h"
#include "core/base/result.h"
#include "core/session/measurement.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// Adds `[--effects FILE|FOLDER]…`, which fills in `paths`.
void addEffectsOption(CLI::App& command, std::vector<std::string>& paths);

/// Reads the user's own effects from the files, and from the `*.alidade-effect` files of each folder, sorted.
Result<std::vector<OwnEffect>> ownEffectsIn(const std::vector<std::string>& paths);

/// Adds those effects in `paths` that have no owner, or whose owner is the session's device or instrument.
std::optional<Problem> addOwnEffects(Session& session, const std::vector<std::string>& paths);

/// Writes the problems of the session's own effects to stderr, under the session's name.
void reportOwnEffects(const std::string& name, const Measurement& measurement);

}  // namespace alidade::console
