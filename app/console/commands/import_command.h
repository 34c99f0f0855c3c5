#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/import.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli import` was asked. Empty texts: not given.
struct ImportRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  std::string out;                 ///< session file to write
  std::string addTo;               ///< session whose readings they are added to; empty: to none
  std::string title, verticalCircle;
  std::string distance, sigmaDistance, radius, tolerance;  ///< mm
  std::string sigma;                                       ///< of both circles, arcseconds
  std::vector<std::string> zero0, zero180;                 ///< horizontal and vertical pointing zero
  std::string zeroPoint;
  std::vector<std::string> axes, rounds;  ///< one for each file, - where the file says it; empty: not given
  std::string unit;                       ///< of plain numbers in a table: deg, gon or dms
  std::string decimalSign;                ///< point or comma
  std::vector<std::string> columns;       ///< of a table: keys, - for one that is not used
  std::optional<std::size_t> headRows;    ///< of a table, before its readings
  std::size_t turnedAtLine = 0;           ///< 0: not given
};

/// Adds `import FILE... --out FILE [--distance MM] [--radius MM] [--zero-0 H V] …`, which fills in `request`.
void addImportCommand(CLI::App& app, ImportRequest& request);

/// What was done, and what the user should know of it.
struct ImportAnswer {
  std::string result;
  std::vector<std::string> remarks;  ///< what was not used, and what the session still lacks
};

/// What the options say. Fails where one cannot be used, or where `out` is the file that is read.
Result<ImportOptions> importOptions(const ImportRequest& request);

/// Writes the session. Fails, and writes nothing, where the file or a line of it cannot be used.
Result<ImportAnswer> runImport(const ImportRequest& request, const ImportOptions& options);

}  // namespace alidade::console
