#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/session/row_fields.h"

namespace alidade {

/// The reason why a line of a file of readings cannot be used, and the remedy.
struct LineProblem {
  std::size_t line = 0;    ///< from 1
  std::size_t column = 0;  ///< character in the line, from 1; 0: the whole line
  std::string what;
  std::string file = {};  ///< name of the file, if there are several
  bool asksUnit = false;  ///< a plain number that may be decimal degrees or degrees, minutes and seconds

  std::string text() const;  ///< `line 3, column 12: …`, preceded by the file

  bool operator==(const LineProblem&) const = default;
};

/// One entry as in the file. An empty text means that the file does not state the entry.
struct RecordedEntry {
  std::string text;
  std::size_t column = 0;  ///< as in LineProblem

  bool operator==(const RecordedEntry&) const = default;
};

/// One sighting as in the file.
struct RecordedSighting {
  std::size_t line = 0;
  RecordedEntry axis;
  Reading row;  ///< angles in a notation of `parseAngle`
  /// The column in the line of each field of `rowFields`, in that order; counted as in LineProblem.
  std::array<std::size_t, rowFields.size()> columns{};
  bool isZero = false;                ///< a sighting of the pointing zero instead of the slider
  int repeat = 1;                     ///< the repeat at its axis if `hasTurns`; else yet to be determined
  std::size_t file = 0;               ///< index of its file; readers of a file do not set it
  std::size_t station = 0;            ///< index among the recording's `stations`
  double distanceM = 0;               ///< 0: not in the file
  bool isDistanceHorizontal = false;  ///< else the distance is along the line of sight

  void enter(const RowField& field, std::string text, std::size_t column);
  std::size_t columnOf(const RowField& field) const;

  bool operator==(const RecordedSighting&) const = default;
};

/// The content of a file of readings, in its order.
struct Recording {
  std::string format;  ///< for people: "GSI-8"
  std::vector<RecordedSighting> sightings;
  std::string instrumentName, instrumentSerial;
  std::string measuredOn;             ///< year-month-day
  std::string verticalCircle;         ///< "zenith", "elevation", or empty if the file does not state it
  std::string circleRemark;           ///< how the kind of vertical circle was inferred, if no name states it
  bool hasTurns = false;              ///< the file states the repeat of each row
  std::vector<LineProblem> problems;  ///< unreadable lines, which `sightings` leaves out
  /// A sentence for each kind of data that a session cannot hold or that was interpreted.
  std::vector<std::string> unused;
  /// A sentence for each kind of data that only the instrument check uses: stations and distances.
  std::vector<std::string> unusedBySession;
  std::vector<LineProblem> distanceProblems;  ///< unreadable distances; the rest of their lines is used
  std::map<std::string, std::size_t> stationIndices;  ///< indices into `stations` by name
  std::vector<std::string> stations{{}};              ///< names; the first is empty: no station stated

  /// The index of the station with this name, which is added if it is new.
  std::size_t stationNamed(const std::string& name);
};

/// The unit of plain numbers that are angles.
enum class AngleUnit {
  Unstated,
  Degrees,  ///< 341.873333
  Gon,      ///< 379.859259
  Radians,  ///< 5.966816; only in columns that state this unit
  Dms,      ///< 341.5224: degrees, then two digits of minutes, two of seconds, and their decimals
};

/// `text` with its unit if it is a plain number: `379.859` becomes `379.859gon`. Other texts stay unchanged.
std::string withUnit(const std::string& text, AngleUnit unit);

}  // namespace alidade
