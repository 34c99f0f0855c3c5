#pragma once

#include <string>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// Adds `schema NAME`, which fills in `name`.
void addSchemaCommand(CLI::App& app, std::string& name);

/// The JSON Schema of a result of this program, or of the session file.
Result<std::string> runSchema(const std::string& name);

}  // namespace alidade::console
