#pragma once

#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli diagnose` was asked.
struct DiagnoseRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  bool each = false;               ///< every file by itself, folders of them, too
  std::string verticalAngle;       ///< exact or planar; empty: as the session says
  std::vector<std::string> without;
  std::string instrument;  ///< path of an instrument record; empty: none
  bool withReference = false;
  BatchOptions batch = {};
};

/// Adds `diagnose FILE… [--each] [--vertical-angle exact|planar] [--without EFFECT]… [--with-reference]
/// [--instrument RECORD] [--threads N] [--progress] [--json]`, which fills in `request`.
void addDiagnoseCommand(CLI::App& app, DiagnoseRequest& request);

/// What many files come to together: every session among them that can be used, each other with a line on
/// stderr and `BadInput`.
int giveSeries(const DiagnoseRequest& request);

/// The answer to one file in text or JSON. Fails where the session cannot be used or an effect is unknown.
Result<std::string> runDiagnose(const DiagnoseRequest& request, const std::string& file);

}  // namespace alidade::console
