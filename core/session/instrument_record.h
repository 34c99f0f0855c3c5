#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade {

/// The text of `KnownSize::from` for a size from the instrument check.
inline constexpr std::string_view fromInstrumentCheck = "instrument check after ISO 17123-3";

/// Knowledge of an instrument that carries over between sessions: the scatter of its circles, and the sizes
/// of its errors with their standard uncertainties. It is a separate file, `*.alidade-instrument`; as in a
/// session, every number is kept as its text.
struct InstrumentRecord {
  std::string name = {}, serial = {};
  std::string certificate = {}, traceability = {};  ///< calibration certificate; traceability of the circles
  std::string date = {};                            ///< date of all findings; required
  std::string due = {};  ///< date of the next check, after `date`; empty: not stated
  /// "zenith" or "elevation": the kind of circle that the sizes of its errors belong to; empty: that of the
  /// session which takes the record.
  std::string verticalCircle = {};
  // An empty text means that the number is not stated.
  std::string sigmaHorizontalArcsec = {}, sigmaVerticalArcsec = {}, sigmaZeroArcsec = {};
  LineOfSight lineOfSight = {};
  std::vector<KnownSize> known = {};
  JsonOrigin origin = {};

  bool operator==(const InstrumentRecord&) const = default;
};

/// Reads the text of a `*.alidade-instrument` file (JSON, UTF-8, format version 1). Fails, with the place, as
/// `readSession` does, and on every invalid entry: a record cannot be edited, so its problems must be
/// reported on reading.
Result<InstrumentRecord> readInstrumentRecord(std::string_view text);

/// The record as the text of a file, ending in a newline. Unknown keys and unchanged values are preserved.
std::string writeInstrumentRecord(const InstrumentRecord& record);

/// Reads a record from a file; the problem says why the file cannot be opened, or what is wrong in it.
Result<InstrumentRecord> loadInstrumentRecord(const std::string& path);

}  // namespace alidade
