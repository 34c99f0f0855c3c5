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

/// The arguments of `alidade-cli import`. An empty text means that the option is not given.
struct ImportRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  std::string out;                 ///< session file to write
  std::string addTo;               ///< session that receives the readings; empty: none
  std::string title, verticalCircle;
  std::string distance, sigmaDistance, radius, tolerance;  ///< mm
  std::string sigma;                                       ///< σ of both circles, arcseconds
  std::vector<std::string> zero0, zero180;                 ///< horizontal and vertical pointing zero
  std::string zeroPoint;
  std::vector<std::string> axes, rounds;  ///< entry for each file, - as the file states; empty: not given
  std::string unit;                       ///< unit of plain numbers in a table: deg, gon or dms
  std::string decimalSign;                ///< point or comma
  std::vector<std::string> columns;       ///< keys of a table's columns, - for an unused one
  std::optional<std::size_t> headRows;    ///< rows of a table before its readings
  std::size_t turnedAtLine = 0;           ///< first line read at 180°; 0: not given
};

/// Adds `import FILE... --out FILE [--distance MM] [--radius MM] [--zero-0 H V] …`, which fills in `request`.
void addImportCommand(CLI::App& app, ImportRequest& request);

/// The result of the import, with remarks for the user.
struct ImportAnswer {
  std::string result;
  std::vector<std::string> remarks;  ///< unused parts of the input, and missing parts of the session
};

/// The options for the import. Fails if one is unusable, or if `out` names a file that is read.
Result<ImportOptions> importOptions(const ImportRequest& request);

/// Writes the session. Fails without writing if a file or one of its lines is unusable.
Result<ImportAnswer> runImport(const ImportRequest& request, const ImportOptions& options);

}  // namespace alidade::console
