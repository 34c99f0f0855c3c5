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
  std::string name;  ///< for sentences; its stem names a station that the file leaves unnamed
  std::string_view bytes;
  std::optional<TableLayout> table = {};  ///< of rows typed into a table; absent: recognised from `bytes`
};

struct CheckFileOptions {
  AngleUnit unit = AngleUnit::Unstated;  ///< of plain numbers in columns without a named unit
  std::string verticalCircle = {};       ///< "zenith" or "elevation"; empty: as the files state
};

/// Sightings from instrument files (GSI, M5, SDR) and tables, whose columns are those of an import
/// (csv_reader.h) and `station`, `target` and `distance`. The vertical circle decides the face. Each file has
/// its own stations; a file that names no station is one station. Numbers without a unit are read as gon,
/// degrees or degrees.minutes seconds: the unit in which the vertical readings of both faces best add up to a
/// full turn. If the table has rounds or sets, `series` distinguishes stations. Fails on the first line that
/// cannot be used, on circles of two kinds, and if there is nothing to evaluate.
Result<CheckReadings> readCheckFiles(const std::vector<CheckFile>& files,
                                     const CheckFileOptions& options = {});

}  // namespace alidade
