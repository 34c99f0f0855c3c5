#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/series/history/quantity_history.h"
#include "core/session/instrument_record.h"

namespace alidade {

/// An instrument record and its file.
struct KeptRecord {
  std::string file;
  InstrumentRecord record;
};

/// The records of one instrument by date, and each of its constants over time.
struct InstrumentHistory {
  std::string name, serial;
  std::vector<KeptRecord> records;
  std::vector<QuantityHistory> quantities;
  std::vector<std::string> leftOut;  ///< a sentence on each size that is not used because of its unit
};

/// Records grouped by instrument (its serial number, else its name). Records with equal contents count once:
/// `copies` pairs each later copy with the first record.
struct InstrumentHistories {
  std::vector<InstrumentHistory> instruments;
  std::vector<std::pair<std::size_t, std::size_t>> copies = {};
};
InstrumentHistories instrumentHistories(const std::vector<KeptRecord>& records);

/// The first `records` records become the baseline of every constant's control chart; 0: all records.
void setBaseline(InstrumentHistory& instrument, std::size_t records);

}  // namespace alidade
