#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/session/session.h"

namespace alidade {

/// What `KnownSize::from` says of a size that the instrument check found.
inline constexpr std::string_view fromInstrumentCheck = "instrument check after ISO 17123-3";

/// What is known of an instrument from one session to the next: how its circles scatter, and the sizes of its
/// errors with their standard uncertainties. A file of its own, `*.alidade-instrument`; as in a session,
/// every number is kept as its text.
struct InstrumentRecord {
  std::string name = {}, serial = {};
  std::string certificate = {}, traceability = {};  ///< of its calibration, of its circles
  std::string date = {};                            ///< on which all of it was found; required
  // Empty: not stated.
  std::string sigmaHorizontalArcsec = {}, sigmaVerticalArcsec = {}, sigmaZeroArcsec = {};
  LineOfSight lineOfSight = {};
  std::vector<KnownSize> known = {};
  JsonOrigin origin = {};

  bool operator==(const InstrumentRecord&) const = default;
};

/// Reads the text of a `*.alidade-instrument` file (JSON, UTF-8, format version 1). Fails, with the place, on
/// what `readSession` fails on, and on every entry that means nothing: a record is not edited, so what is
/// wrong with it must be said when it is taken.
Result<InstrumentRecord> readInstrumentRecord(std::string_view text);

/// The record as the text of a file, ending in a newline. Unknown keys and untouched values survive.
std::string writeInstrumentRecord(const InstrumentRecord& record);

/// Reads a record from a file; the sentence names the file's trouble where it cannot be opened.
Result<InstrumentRecord> loadInstrumentRecord(const std::string& path);

}  // namespace alidade
