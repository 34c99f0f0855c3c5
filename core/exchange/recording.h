#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/session/row_fields.h"

namespace alidade {

/// Why a line of a file of readings cannot be used, and what to do.
struct LineProblem {
  std::size_t line = 0;    ///< from 1
  std::size_t column = 0;  ///< character of the line, from 1; 0: the line as a whole
  std::string what;
  std::string file = {};  ///< its name, where there are several

  std::string text() const;  ///< `line 3, column 12: …`, with the file in front

  bool operator==(const LineProblem&) const = default;
};

/// One entry as the file has it. Empty text: the file does not say.
struct RecordedEntry {
  std::string text;
  std::size_t column = 0;  ///< as in LineProblem

  bool operator==(const RecordedEntry&) const = default;
};

/// One sighting as the file has it.
struct RecordedSighting {
  std::size_t line = 0;
  RecordedEntry axis;
  Reading row;  ///< angles in a notation of `parseAngle`
  /// Where the row's fields stand in the line, in the order of `rowFields`; as in LineProblem.
  std::array<std::size_t, rowFields.size()> columns{};
  bool isZero = false;  ///< of the pointing zero, not of the slider
  int time = 1;  ///< the how many-th position at its axis it is of, where `tellsTurns`; else to be found
  std::size_t file = 0;               ///< index of its file among several; who reads a file leaves it
  std::size_t station = 0;            ///< index among the recording's `stations`
  double distanceM = 0;               ///< 0: the file does not say
  bool isDistanceHorizontal = false;  ///< else along the line of sight

  void enter(const RowField& field, std::string text, std::size_t column);
  std::size_t columnOf(const RowField& field) const;

  bool operator==(const RecordedSighting&) const = default;
};

/// What a file of readings says, in its order.
struct Recording {
  std::string format;  ///< for people: "GSI-8"
  std::vector<RecordedSighting> sightings;
  std::string instrumentName, instrumentSerial;
  std::string measuredOn;             ///< year-month-day
  std::string verticalCircle;         ///< "zenith", "elevation", or empty where the file does not say
  std::string circleRemark;           ///< why the vertical circle is taken so where no name says it
  bool tellsTurns = false;            ///< the file says which position at its axis a row is of
  std::vector<LineProblem> problems;  ///< lines that cannot be read; nothing of them is in `sightings`
  /// A sentence for each kind of thing that a session has no place for, or that was read in a way of its own.
  std::vector<std::string> unused;
  /// Likewise of stations and distances, which the check of an instrument has a place for.
  std::vector<std::string> unusedBySession;
  std::vector<LineProblem> distanceProblems;  ///< distances that cannot be read; the rest of the line stands
  std::map<std::string, std::size_t> stationIndices;  ///< of `stations`
  std::vector<std::string> stations{{}};  ///< their names; the first, without one, is where none is said

  /// The index of a station, which is new where it is not known.
  std::size_t stationNamed(const std::string& name);
};

/// The unit of plain numbers where an angle is wanted.
enum class AngleUnit {
  Unstated,
  Degrees,  ///< 341.873333
  Gon,      ///< 379.859259
  Radians,  ///< 5.966816; of columns that say so
  Dms,      ///< 341.5224: degrees, then two digits of minutes, two of seconds, and their decimals
};

/// `text` with its unit, where it is a plain number: `379.859` as `379.859gon`. Everything else stays.
std::string withUnit(const std::string& text, AngleUnit unit);

}  // namespace alidade
