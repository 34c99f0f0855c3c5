#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// What `alidade-cli instrument` was asked.
struct InstrumentRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  std::optional<double> sigma, sigmaVertical;
  std::string unit;            ///< deg, gon or dms; empty: as the files have it
  std::string verticalCircle;  ///< zenith or elevation; empty: as the files have it
  std::string record;          ///< instrument record to write; empty: none
  std::string date;            ///< of the record; empty: as the files have it
  bool json = false;
};

struct InstrumentAnswer {
  std::string result;
  std::vector<std::string> remarks;  ///< for stderr
};

/// Adds `instrument FILE… [--sigma ARCSEC] [--sigma-vertical ARCSEC] [--unit …] [--vertical-circle …]
/// [--record FILE] [--date DAY] [--json]`, which fills in `request`.
void addInstrumentCommand(CLI::App& app, InstrumentRequest& request);

/// The answer in text or JSON, after the record is written. Fails where a file cannot be used, a figure
/// cannot be right, or the record has nothing to hold or cannot be written.
Result<InstrumentAnswer> runInstrument(const InstrumentRequest& request);

}  // namespace alidade::console
