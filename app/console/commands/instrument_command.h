#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/series/instrument_check/check_readings.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli instrument`.
struct InstrumentRequest {
  std::vector<std::string> files;  ///< paths, or - for standard input
  std::optional<double> sigma, sigmaVertical;
  std::string unit;             ///< deg, gon or dms; empty: from the files
  std::string verticalCircle;   ///< zenith or elevation; empty: from the files
  std::string record;           ///< instrument record to write; empty: none
  CheckIdentity identity = {};  ///< replaces what the files state
  bool json = false;
};

struct InstrumentAnswer {
  std::string result;
  std::vector<std::string> remarks;  ///< for stderr
};

/// Adds `instrument FILE… [--sigma ARCSEC] [--sigma-vertical ARCSEC] [--unit …] [--vertical-circle …]
/// [--record FILE] [--name TEXT] [--serial TEXT] [--date DAY] [--due DAY] [--json]`, which fills in
/// `request`.
void addInstrumentCommand(CLI::App& app, InstrumentRequest& request);

/// The check as text or JSON, after writing the record. Fails if a file is unusable, a figure is implausible,
/// a day is invalid, or the record is empty or cannot be written.
Result<InstrumentAnswer> runInstrument(const InstrumentRequest& request);

}  // namespace alidade::console
