#pragma once

#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli diagnose`.
struct DiagnoseRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  bool each = false;               ///< whether to diagnose each file separately, also the files of a folder
  std::string verticalAngle;       ///< exact or planar; empty: from the session
  std::vector<std::string> without;
  std::string instrument;            ///< path of an instrument record; empty: none
  std::vector<std::string> effects;  ///< files and folders of effects of the user's own
  std::string keepForm;              ///< file to write the first form to; empty: none
  bool withReference = false;
  BatchOptions batch = {};
};

/// Adds `diagnose FILE… [--each] [--vertical-angle exact|planar] [--without EFFECT]… [--with-reference]
/// [--instrument RECORD] [--effects FILE|FOLDER]… [--keep-form FILE] [--threads N] [--progress] [--json]`,
/// which fills in `request`.
void addDiagnoseCommand(CLI::App& app, DiagnoseRequest& request);

/// Writes the common result of all usable sessions among the files. Each unusable session gets a line on
/// stderr, and the exit code is then `BadInput`.
int giveSeries(const DiagnoseRequest& request);

/// The diagnosis of one file as text or JSON. Fails if the session is unusable or an effect is unknown.
Result<std::string> runDiagnose(const DiagnoseRequest& request, const std::string& file);

}  // namespace alidade::console
