#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/exchange/exact_angle.h"
#include "core/exchange/field_mark.h"
#include "core/exchange/recording.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

/// Builds a recording from an instrument's file, whose marks state the axis, the round and the pointing zero.
/// If `zeroPoint` is empty, points 0 and ZERO are the zero.
class FieldBook {
 public:
  explicit FieldBook(const std::string& zeroPoint) : m_zeroPoint(zeroPoint) {}

  /// Passes each line of the file to `readLine` until a limit is reached, and lists the content after the
  /// end of the file, if there is any.
  void readLines(std::string_view text, const std::function<void(const TextLine&)>& readLine);
  void take(const FieldMark& mark);
  /// Adds a sighting with the axis, round and zero of the preceding marks. True if it is of the pointing
  /// zero.
  bool add(RecordedSighting sighting);
  /// Enters the reading of a circle, and remarks on a carry.
  void enter(RecordedSighting& sighting, const RowField& circle, ExactAngle angle, std::size_t column);
  /// Counts interpreted values for one remark: %1 in `sentence` is their number, %2 their first line.
  void note(const char* sentence, std::size_t line);
  void refuse(std::size_t line, std::size_t column, const std::string& what);
  /// Lists data that a session cannot hold, once for each kind.
  void setAside(const std::string& what, std::size_t line);
  /// Lists a sighting that a session cannot hold. It takes up a preceding mark of the zero.
  void setAsideSighting(const std::string& what, std::size_t line);
  /// Ends a mark of the zero whose sighting holds nothing.
  void dropZeroMark() { m_zeroComes = false; }
  /// Lists a line outside the format. The first few are quoted; the others are counted.
  void setAsideLine(std::string_view text, std::size_t line);
  /// Lists a part of a line outside the format. The first few are quoted; the others are counted.
  void setAsidePart(std::string_view text, std::size_t line);
  /// Lists data that a session cannot hold but an instrument check can.
  void setAsideForCheck(const std::string& what, std::size_t line) { count(m_forCheck, what, line); }
  /// Begins a station, to which the sightings that follow belong.
  void beginStation(const std::string& name, std::size_t line);
  /// Keeps the first value; a different later one is listed as unused under `name`.
  void keep(std::string& value, const std::string& text, const std::string& name, std::size_t line);
  /// Is a limit of rows or problems reached, so that reading stops?
  bool isFull(std::size_t line);

  /// Does the current station have a sighting?
  bool isStationUsed() const { return m_isStationUsed; }

  Recording& recording() { return m_recording; }
  Recording finish(const std::string& format);

 private:
  struct Unused {
    std::size_t count = 0, firstLine = 0;
  };

  using Uses = std::map<std::string, Unused>;
  static void count(Uses& uses, const std::string& what, std::size_t line);
  static std::string sentence(const std::string& what, const Unused& unused);

  static constexpr std::size_t mostQuoted = 3;

  std::string m_zeroPoint;
  std::size_t m_quotedLines = 0, m_quotedParts = 0;
  std::string m_axis, m_round;
  bool m_zeroComes = false;
  Uses m_unused, m_forCheck;
  std::map<const char*, Unused> m_notes;
  std::size_t m_station = 0;
  bool m_isStationUsed = false;
  Recording m_recording;
};

}  // namespace alidade
