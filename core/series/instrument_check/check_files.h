#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/table_layout.h"
#include "core/series/instrument_check/check_readings.h"

namespace alidade {

struct CheckFile {
  std::string
      name;  ///< for sentences, and of a station that the file does not name; its last ending is left off
  std::string_view bytes;
  std::optional<TableLayout> table = {};  ///< of rows typed into a table; absent: as the file has it
};

struct CheckFileOptions {
  AngleUnit unit = AngleUnit::Unstated;  ///< of plain numbers in columns that name none
  std::string verticalCircle = {};       ///< "zenith" or "elevation"; empty: as the files say
};

/// Sightings from the files of instruments (GSI, M5, SDR) and tables, whose columns are those of an import
/// (csv_reader.h) and `station`, `target` and `distance`. The face is what the vertical circle shows. Each
/// file has stations of its own; one that names none is a station itself. Plain numbers are gon, degrees or
/// degrees.minutes seconds, whichever lets the vertical readings of two faces add up to a full turn. `series`
/// tells stations apart where the table has rounds or sets besides. Fails on the first line that cannot be
/// used, on circles of two kinds, and where there is nothing to evaluate.
Result<CheckReadings> readCheckFiles(const std::vector<CheckFile>& files,
                                     const CheckFileOptions& options = {});

}  // namespace alidade
