#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli diagnose` was asked.
struct DiagnoseRequest {
  std::string file;           ///< a path, or - for standard input
  std::string verticalAngle;  ///< exact or planar; empty: as the session says
  std::vector<std::string> without;
  std::string instrument;  ///< path of an instrument record; empty: none
  bool withReference = false;
  bool json = false;
};

/// Adds `diagnose FILE [--vertical-angle exact|planar] [--without EFFECT]… [--with-reference] [--instrument
/// RECORD]
/// [--json]`, which fills in `request`.
void addDiagnoseCommand(CLI::App& app, DiagnoseRequest& request);

/// The answer in text or JSON. Fails where the session cannot be used or an effect is unknown.
Result<std::string> runDiagnose(const DiagnoseRequest& request);

}  // namespace alidade::console
