#include "core/exchange/sdr_reader.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/utf8.h"
#include "core/base/visible_text.h"
#include "core/exchange/exact_angle.h"
#include "core/exchange/field_book.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Columns from 1, both included.
struct Columns {
  std::size_t first, last;
};

struct SightingColumns {
  Columns station, point, vertical, horizontal, note;
};

constexpr SightingColumns columnsOf33{{5, 20}, {21, 36}, {53, 68}, {69, 84}, {85, 100}};
constexpr SightingColumns columnsOf2x{{5, 8}, {9, 12}, {23, 32}, {33, 42}, {43, 58}};

/// Record types that are not used. `what` names the data in a remark. Null: target height, atmosphere, scale,
/// bearing to a station and job are ignored without a remark.
struct UnusedRecord {
  std::string_view type;
  const char* what;
};
constexpr UnusedRecord unusedRecords[] = {
    {"03", nullptr},
    {"04", PHRASE_LATER("Phrase", "the collimation of the instrument (04)")},
    {"05", nullptr},
    {"06", nullptr},
    {"07", nullptr},
    {"08", PHRASE_LATER("Phrase", "a record of coordinates (08)")},
    {"10", nullptr},
    {"11", PHRASE_LATER("Phrase", "a reduced observation (11)")},
    {"12", PHRASE_LATER("Phrase", "a record of a set (12)")},
};

bool areAllDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The ways in which programs count the columns of characters beyond ASCII.
enum class Counted { Characters, WideAsTwo, Bytes };

std::size_t columnsBeyondOne(const Utf8Character& character, Counted counted) {
  constexpr char32_t firstOfEastAsia = 0x2E80;
  if (counted == Counted::Bytes) return character.length - 1;
  return counted == Counted::WideAsTwo && character.code >= firstOfEastAsia ? 1 : 0;
}

/// The line with one character per column: blanks after a word compensate for its wide characters.
std::string aligned(std::string_view line, Counted counted) {
  std::string text;
  std::size_t behind = 0;
  while (!line.empty()) {
    const Utf8Character character = firstCharacter(line);
    if (line[0] == ' ') text.append(std::exchange(behind, 0), ' ');
    behind += columnsBeyondOne(character, counted);
    text += line.substr(0, character.length);
    line.remove_prefix(character.length);
  }
  return text;
}

/// The text in these columns, without surrounding blanks; lines may end early.
std::string fieldOf(std::string_view line, Columns columns) {
  const auto skip = [](std::string_view& rest, std::size_t count) {
    std::size_t bytes = 0;
    for (; count > 0 && bytes < rest.size(); --count) bytes += firstCharacter(rest.substr(bytes)).length;
    const std::string_view skipped = rest.substr(0, bytes);
    rest.remove_prefix(bytes);
    return skipped;
  };
  skip(line, columns.first - 1);
  return trimmed(skip(line, columns.last - columns.first + 1));
}

/// Does a number begin in these columns and not before?
bool isNumberAt(std::string_view line, Columns at) {
  const std::string before = fieldOf(line, {at.first - 1, at.first - 1}), number = fieldOf(line, at);
  return (before.empty() || !isDigit(before[0])) && exactAngle(number, "deg");
}

/// Reads a file record by record.
class SdrReader {
 public:
  explicit SdrReader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    m_book.readLines(text, [this](const TextLine& line) { readRecord(line); });
    refuseMeansAlone();
    return m_book.finish(m_is33 ? "SDR33" : "SDR2x");
  }

 private:
  /// Refuses a field at its column, or at the end of a line that is too short.
  void refuse(const TextLine& line, std::size_t column, const std::string& what) {
    m_book.refuse(line.number, std::min(column, characterCount(line.text) + 1), what);
  }

  /// Refuses a file that holds only corrected means: they are not circle readings.
  void refuseMeansAlone() {
    const Recording& recording = m_book.recording();
    if (m_firstMean == 0 || !recording.sightings.empty() || !recording.problems.empty()) return;
    m_book.refuse(m_firstMean, 0,
                  Phrase::of("is a corrected mean (09MC), and the file holds nothing else: send the "
                             "observations raw (09F1, 09F2)"));
  }

  void readRecord(TextLine line) {
    constexpr char begins = '\x02', ends = '\x03';  // marks of a transmission
    constexpr std::size_t longestCheckSum = 5;
    if (line.text.starts_with(begins)) line.text.remove_prefix(1);
    const std::string plain = trimmed(line.text);
    if (plain.empty() || line.text[0] == ends) return;
    if (areAllDigits(plain) && plain.size() <= longestCheckSum) return;
    const std::string_view type = line.text.substr(0, 2),
                           from = line.text.substr(std::min<std::size_t>(line.text.size(), 2), 2);
    if (type == "00") return readHeading(line);
    if (!m_hasHeading) return m_book.setAsideLine(plain, line.number);
    if (!m_unit) return;  // the heading could not be read, and a problem is reported
    if (type == "01") return readInstrument(line);
    if (type == "02") return takeStation(fieldOf(line.text, columns(line).station), line.number);
    if (type == "09") return readObservation(line, from);
    if (type == "13") return from == "TS" ? void() : readNote(line);  // TS: the time
    readUnused(line, type, from);
  }

  /// The line, aligned so that the columns of both circles hold numbers; unchanged if no counting fits.
  static std::string inColumns(std::string_view line, const SightingColumns& at) {
    for (const Counted counted : {Counted::Characters, Counted::WideAsTwo, Counted::Bytes}) {
      std::string text = aligned(line, counted);
      if (isNumberAt(text, at.vertical) && isNumberAt(text, at.horizontal)) return text;
    }
    return std::string(line);
  }

  /// The columns of SDR33, unless the heading says otherwise and the line is too short for them.
  SightingColumns columns(const TextLine& line) const {
    const bool isLong = characterCount(line.text) >= columnsOf33.horizontal.first;
    return m_is33 || isLong ? columnsOf33 : columnsOf2x;
  }

  void takeStation(const std::string& name, std::size_t line) {
    if (name.empty() || name == m_station) return;
    m_station = name;
    m_book.beginStation(name, line);
  }

  static bool isRaw(std::string_view from) { return from == "F1" || from == "F2" || from == "MD"; }

  /// Lists deleted and undocumented records, and lines that are not records.
  void readUnused(const TextLine& line, std::string_view type, std::string_view from) {
    const auto* const known = std::ranges::find(unusedRecords, type, &UnusedRecord::type);
    if (known != std::end(unusedRecords)) {
      if (known->what) m_book.setAside(Phrase::of(known->what), line.number);
    } else if (type == "DD") {
      m_book.setAsideSighting(Phrase::of("a deleted record"), line.number);
    } else if (isRaw(from) && !areAllDigits(type)) {
      m_book.refuse(
          line.number, 0,
          Phrase::of("%1 is no record of an SDR file: transfer the file again, or correct or delete the line",
                     quotation(line.text)));
    } else if (areAllDigits(type)) {
      m_book.setAside(Phrase::of("a record of the unknown type %1", quotation(type)), line.number);
    } else {
      m_book.setAsideLine(line.text, line.number);
    }
  }

  void readHeading(const TextLine& line) {
    m_hasHeading = true;
    m_is33 = fieldOf(line.text, {5, 20}).starts_with("SDR3");
    m_unit.reset();
    m_isElevation.reset();
    const std::string unit = fieldOf(line.text, {41, 41}), direction = fieldOf(line.text, {46, 46});
    if (unit != "1" && unit != "2")
      return refuse(line, 41,
                    Phrase::of("%1 is not a supported unit of angles (1: degrees, 2: gon): set the "
                               "instrument to one of them and transfer again",
                               quotation(unit)));
    if (!direction.empty() && direction != "1")
      return refuse(line, 46,
                    Phrase::of("%1 means angles that increase to the left: set the instrument to increase to "
                               "the right and measure again",
                               quotation(direction)));
    m_unit = unit == "1" ? "deg" : "gon";
  }

  void readInstrument(const TextLine& line) {
    Recording& recording = m_book.recording();
    const std::string name = fieldOf(line.text, {6, 21}), serial = fieldOf(line.text, {22, 27}),
                      circle = fieldOf(line.text, {51, 51});
    if (!name.empty()) m_book.keep(recording.instrumentName, name, Phrase::of("instrument"), line.number);
    if (!serial.empty())
      m_book.keep(recording.instrumentSerial, serial, Phrase::of("instrument"), line.number);
    if (circle == "1" || circle == "2") m_isElevation = circle == "2";
  }

  void readObservation(TextLine line, std::string_view from) {
    if (from == "MC") {
      if (m_firstMean == 0) m_firstMean = line.number;
      return m_book.setAside(Phrase::of("a corrected mean, not a circle reading (09MC)"), line.number);
    }
    if (!isRaw(from))
      return m_book.setAsideSighting(Phrase::of("an observation that is not raw (09%1)", from), line.number);
    const SightingColumns at = columns(line);
    const bool isAscii = std::ranges::none_of(line.text, [](char c) { return (c & 0x80) != 0; });
    const std::string text = isAscii ? std::string() : inColumns(line.text, at);
    if (!isAscii) line.text = text;
    RecordedSighting sighting;
    sighting.line = line.number;
    sighting.enter(rowField(&Reading::point), fieldOf(line.text, at.point),
                   std::min(at.point.first, characterCount(line.text) + 1));
    sighting.row.note = fieldOf(line.text, at.note);
    if (from != "MD") sighting.row.face = from.substr(1);
    if (!takeAngle(line, at.horizontal, rowField(&Reading::horizontal), sighting)) return;
    if (!takeAngle(line, at.vertical, rowField(&Reading::vertical), sighting)) return;
    if (!takeCircle(line.number)) return;
    takeStation(fieldOf(line.text, at.station), line.number);
    m_book.add(std::move(sighting));
  }

  bool takeAngle(const TextLine& line, Columns at, const RowField& circle, RecordedSighting& sighting) {
    const std::string number = fieldOf(line.text, at);
    if (number.empty()) {
      refuse(line, at.first,
             circle.text == &Reading::horizontal
                 ? Phrase::of("has no horizontal reading: delete the line, or sight the point again")
                 : Phrase::of("has no vertical reading: delete the line, or sight the point again"));
      return false;
    }
    const auto angle = exactAngle(number, *m_unit);
    if (!angle) {
      refuse(line, at.first,
             Phrase::of("%1 is no number: transfer the file again, or correct or delete the line",
                        quotation(number)));
      return false;
    }
    m_book.enter(sighting, circle, *angle, at.first);
    return true;
  }

  /// Keeps the kind of vertical circle. False, with a problem, if earlier jobs have the other kind.
  bool takeCircle(std::size_t line) {
    if (!m_isElevation) return true;
    std::string& known = m_book.recording().verticalCircle;
    const std::string own = *m_isElevation ? "elevation" : "zenith";
    if (!known.empty() && known != own) {
      m_book.refuse(line, 0,
                    Phrase::of("is from an instrument with the other kind of vertical circle: import the "
                               "jobs from separate files"));
      return false;
    }
    known = own;
    return true;
  }

  void readNote(const TextLine& line) {
    const std::string note = fieldOf(line.text, {5, 64});
    if (const auto mark = fieldMark(note)) return m_book.take(*mark);
    if (!note.empty()) m_book.setAside(Phrase::of("the note %1", quotation(note)), line.number);
  }

  FieldBook m_book;
  bool m_is33 = true, m_hasHeading = false;
  std::string m_station;              ///< current station
  std::size_t m_firstMean = 0;        ///< line of the first 09MC; 0 if there is none
  std::optional<std::string> m_unit;  ///< unit of angles of the job; absent if it cannot be read
  std::optional<bool> m_isElevation;  ///< kind of vertical circle; absent if the job does not state it
};

}  // namespace

bool looksLikeSdr(std::string_view line) {
  if (!line.empty() && line[0] == '\x02') line.remove_prefix(1);
  return line.starts_with("00") && fieldOf(line, {5, 20}).starts_with("SDR");
}

Recording readSdr(std::string_view text, const std::string& zeroPoint) {
  return SdrReader(zeroPoint).read(text);
}

}  // namespace alidade
