#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace alidade {

/// The suffix of a series file.
inline constexpr std::string_view seriesSuffix = ".alidade-series";

/// The sessions of a series.
struct SeriesFile {
  std::vector<std::string> sessions;  ///< paths; in the file, relative to the folder of the file
  std::size_t baseline = 0;           ///< number of first sessions in the baseline; 0: all

  bool operator==(const SeriesFile&) const = default;
};

/// True if the path has the suffix of a series.
bool isSeriesPath(std::string_view path);

/// Reads the text of a `*.alidade-series` file (JSON, UTF-8, format version 1). Problems name the place.
Result<SeriesFile> readSeriesFile(std::string_view text);
/// The series as the text of a file, ending in a newline.
std::string writeSeriesFile(const SeriesFile& series);

/// Reads a series from a file, with its sessions as paths that can be opened.
Result<SeriesFile> loadSeriesFile(const std::string& path);
/// The path of a session relative to the folder of the series file, with / between its parts.
std::string pathInSeries(const std::string& session, const std::string& seriesPath);

}  // namespace alidade
