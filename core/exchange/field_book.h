#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "core/exchange/exact_angle.h"
#include "core/exchange/field_mark.h"
#include "core/exchange/recording.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

/// A recording in the making from the file of an instrument, which says by marks how the axis stood, which
/// round it was and what was the pointing zero. Where `zeroPoint` is empty, points 0 and ZERO are the zero.
class FieldBook {
 public:
  explicit FieldBook(const std::string& zeroPoint) : m_zeroPoint(upperCase(zeroPoint)) {}

  void take(const FieldMark& mark);
  /// With axis, round and zero as the marks before it have them. True: it is of the pointing zero.
  bool add(RecordedSighting sighting);
  /// The reading of a circle; told of where it was carried.
  void enter(RecordedSighting& sighting, const RowField& circle, ExactAngle angle, std::size_t column);
  /// What was read in a way of its own, told once: %1 in `sentence` is how often, %2 the first line.
  void note(const char* sentence, std::size_t line);
  /// What stands behind the end of the file, if anything.
  void setAsideTail(const TextLines& lines);
  void refuse(std::size_t line, std::size_t column, const std::string& what);
  /// A session has no place for it; told once for each kind.
  void setAside(const std::string& what, std::size_t line);
  /// A line that is none of the format. The first few are quoted; the others are counted.
  void setAsideLine(std::string_view text, std::size_t line);
  /// Likewise a part of a line.
  void setAsidePart(std::string_view text, std::size_t line);
  /// Likewise, though the check of an instrument has one.
  void setBeside(const std::string& what, std::size_t line) { count(m_beside, what, line); }
  /// What follows was sighted from there.
  void beginStation(const std::string& name, std::size_t line);
  /// The first value counts; another one is set aside as `name` with it.
  void keep(std::string& value, const std::string& text, const std::string& name, std::size_t line);
  /// Reads nothing further: there are more rows or problems than are worked on.
  bool isFull(std::size_t line);

  /// Has the station that stands been sighted from?
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
  Uses m_unused, m_beside;
  std::map<const char*, Unused> m_notes;
  std::size_t m_station = 0;
  bool m_isStationUsed = false;
  Recording m_recording;
};

}  // namespace alidade
