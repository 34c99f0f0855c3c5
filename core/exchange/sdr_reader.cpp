#include "core/exchange/sdr_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/phrase.h"
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
  Columns point, vertical, horizontal, note;
};

constexpr SightingColumns columnsOf33{{21, 36}, {53, 68}, {69, 84}, {85, 100}};
constexpr SightingColumns columnsOf2x{{9, 12}, {23, 32}, {33, 42}, {43, 58}};

/// What stands there, without blanks around; lines may be cut behind their last sign.
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

/// Goes through a file record by record.
class SdrReader {
 public:
  explicit SdrReader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    TextLines lines(text);
    while (const auto line = lines.next()) {
      readRecord(*line);
      if (m_book.isFull(line->number)) break;
    }
    return m_book.finish(m_is33 ? "SDR33" : "SDR2x");
  }

 private:
  /// At the column, or the end of a line that is cut before it.
  void refuse(const TextLine& line, std::size_t column, const std::string& what) {
    m_book.refuse(line.number, std::min(column, characterCount(line.text) + 1), what);
  }

  void readRecord(TextLine line) {
    constexpr char begins = '\x02', ends = '\x03';  // of a transmission
    if (line.text.starts_with(begins)) line.text.remove_prefix(1);
    if (line.text.find_first_not_of(" \t") == std::string_view::npos || line.text[0] == ends) return;
    const std::string_view type = line.text.substr(0, 2),
                           from = line.text.substr(std::min<std::size_t>(line.text.size(), 2), 2);
    if (type == "00") return readHeading(line);
    if (!m_unit) return;  // the heading could not be read, and said so
    if (type == "01") return readInstrument(line);
    if (type == "09") return readObservation(line, from);
    if (type == "13") return from == "TS" ? void() : readNote(line);  // the time
    if (type == "08") return m_book.setAside(Phrase::of("a record of coordinates (08)"), line.number);
    if (type == "02" && m_hasStation)
      return m_book.setAside(Phrase::of("another record of a station (02)"), line.number);
    m_hasStation = m_hasStation || type == "02";
    constexpr std::string_view passed = "02 03 05 06 07 10 11 12";  // station, target, program's own
    if (type.size() == 2 && passed.find(type) != std::string_view::npos) return;
    m_book.refuse(
        line.number, 0,
        Phrase::of("%1 is no record of an SDR file: transfer the file anew, or mend or delete the line",
                   quotation(line.text)));
  }

  void readHeading(const TextLine& line) {
    m_is33 = fieldOf(line.text, {5, 20}).starts_with("SDR33");
    m_unit.reset();
    m_isElevation.reset();
    const std::string unit = fieldOf(line.text, {41, 41}), direction = fieldOf(line.text, {46, 46});
    if (unit != "1" && unit != "2")
      return refuse(
          line, 41,
          Phrase::of("%1 is no unit of angles that is read here: 1 is degrees, 2 gon; set the instrument "
                     "to one of them and transfer anew",
                     quotation(unit)));
    if (!direction.empty() && direction != "1")
      return refuse(
          line, 46,
          Phrase::of("%1 stands for angles that grow to the left: set the instrument to the right and "
                     "measure anew",
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

  void readObservation(const TextLine& line, std::string_view from) {
    if (from == "MC")
      return m_book.setAside(Phrase::of("a corrected mean, no reading of circles (09MC)"), line.number);
    if (from != "F1" && from != "F2" && from != "MD")
      return m_book.setAside(Phrase::of("an observation that is not raw (09%1)", from), line.number);
    const SightingColumns& at = m_is33 ? columnsOf33 : columnsOf2x;
    RecordedSighting sighting;
    sighting.line = line.number;
    sighting.enter(rowField(&Reading::point), fieldOf(line.text, at.point),
                   std::min(at.point.first, characterCount(line.text) + 1));
    sighting.row.note = fieldOf(line.text, at.note);
    if (from != "MD") sighting.row.face = from.substr(1);
    if (!takeAngle(line, at.horizontal, rowField(&Reading::horizontal), sighting)) return;
    if (!takeAngle(line, at.vertical, rowField(&Reading::vertical), sighting)) return;
    if (!takeCircle(line.number)) return;
    m_book.add(std::move(sighting));
  }

  bool takeAngle(const TextLine& line, Columns columns, const RowField& circle, RecordedSighting& sighting) {
    const std::string number = fieldOf(line.text, columns);
    if (number.empty()) {
      refuse(line, columns.first,
             circle.text == &Reading::horizontal
                 ? Phrase::of("has no horizontal reading: delete the line, or sight the point again")
                 : Phrase::of("has no vertical reading: delete the line, or sight the point again"));
      return false;
    }
    const auto angle = exactAngle(number, *m_unit);
    if (!angle) {
      refuse(line, columns.first,
             Phrase::of("%1 is no number: transfer the file anew, or mend or delete the line",
                        quotation(number)));
      return false;
    }
    sighting.enter(circle, *angle, columns.first);
    return true;
  }

  /// All jobs of a file with one kind of vertical circle.
  bool takeCircle(std::size_t line) {
    if (!m_isElevation) return true;
    std::string& known = m_book.recording().verticalCircle;
    const std::string own = *m_isElevation ? "elevation" : "zenith";
    if (!known.empty() && known != own) {
      m_book.refuse(
          line, 0,
          Phrase::of("is of an instrument with the other kind of vertical circle: import the jobs in "
                     "files of their own"));
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
  bool m_is33 = true, m_hasStation = false;
  std::optional<std::string> m_unit;  ///< of the job; absent where it is none that is read
  std::optional<bool> m_isElevation;  ///< the vertical circle; absent where the job does not say
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
