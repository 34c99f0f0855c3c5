#include "core/exchange/m5_reader.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/exact_angle.h"
#include "core/exchange/field_book.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr std::size_t pointWidth = 12;

constexpr const char* backsightZero = PHRASE_LATER("Phrase",
                                                   "sightings of a point 0 when the station was set up (KN "
                                                   "STAT), taken as the pointing zero: %1, first in line %2");

struct Block {
  std::string_view text;
  std::size_t column = 0;
};

/// A number with its type and unit, such as `Hz 34.9078 gon`.
struct Value {
  std::string type, number, unit;
  std::size_t column = 0;  ///< column of the number; without one, of the block
};

std::vector<Block> blocksOf(std::string_view line) {
  std::vector<Block> blocks;
  for (std::size_t column = 1;;) {
    const std::string_view text = line.substr(0, line.find('|'));
    blocks.push_back({text, column});
    if (text.size() == line.size()) return blocks;
    column += characterCount(text) + 1;
    line.remove_prefix(text.size() + 1);
  }
}

std::vector<Block> wordsIn(const Block& block) {
  std::vector<Block> words;
  std::size_t at = 0;
  while ((at = block.text.find_first_not_of(" \t", at)) != std::string_view::npos) {
    const std::size_t end = std::min(block.text.find_first_of(" \t", at), block.text.size());
    words.push_back(
        {block.text.substr(at, end - at), block.column + characterCount(block.text.substr(0, at))});
    at = end;
  }
  return words;
}

/// Does the block contain a point or a text, instead of an address?
bool isPointOrText(const Block& block) {
  return block.text.starts_with("PI") || block.text.starts_with("TI") || block.text.starts_with("TO");
}

/// The type in its usual case: some programs write Hz and V1 differently.
std::string typeOf(std::string_view written) {
  const std::string large = upperCase(std::string(written));
  if (large == "HZ") return "Hz";
  return large == "V1" || large == "V3" ? large : std::string(written);
}

/// Splits a block into type, number and unit: the type is a number (01) or a name (Hz).
Value valueOf(const Block& block) {
  const std::vector<Block> words = wordsIn(block);
  if (words.empty()) return {.type = {}, .number = {}, .unit = {}, .column = block.column};
  Value value{.type = typeOf(words[0].text), .number = {}, .unit = {}, .column = block.column};
  if (words.size() < 2) return value;
  value.column = words[1].column;
  const std::size_t last = words.size() > 2 ? words.size() - 1 : words.size();
  for (std::size_t i = 1; i < last; ++i) value.number += (i > 1 ? " " : "") + std::string(words[i].text);
  if (last < words.size()) value.unit = std::string(words[last].text);
  return value;
}

bool isCircleValue(const Value& value) {
  return value.type == "Hz" || (value.type.size() == 2 && value.type[0] == 'V');
}

/// Reads a file line by line.
class M5Reader {
 public:
  explicit M5Reader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    m_book.readLines(text, [this](const TextLine& line) { readLine(line); });
    return m_book.finish("M5");
  }

 private:
  void readLine(const TextLine& line) {
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos || line.text.substr(first).starts_with("END")) return;
    if (std::string_view("!#").find(line.text[first]) != std::string_view::npos)
      return m_book.setAside(Phrase::of("the line %1", quotation(line.text.substr(first))), line.number);
    if (!looksLikeM5(line.text)) return readOther(line);
    constexpr std::size_t fewest = 3;  // format, text, one number
    std::vector<Block> blocks = blocksOf(line.text);
    const bool hasAddress = blocks.size() > 1 && !isPointOrText(blocks[1]);
    if (hasAddress) blocks.erase(blocks.begin() + 1);
    if (blocks.size() < fewest) return refuseLine(line);
    std::vector<Value> values;
    for (std::size_t i = 2; i < std::min<std::size_t>(blocks.size(), 5); ++i)
      values.push_back(valueOf(blocks[i]));
    if (blocks.size() > 5 && trimmed(blocks[5].text) == "e" && std::ranges::any_of(values, isCircleValue))
      return m_book.refuse(
          line.number, blocks[5].column,
          Phrase::of("is marked with e, an error of the instrument: measure the point again"));
    if (blocks[1].text.starts_with("PI")) {
      readPoint(blocks[1], values, line.number);
    } else {
      readText(blocks[1], values, line.number);
    }
  }

  void refuseLine(const TextLine& line) {
    m_book.refuse(line.number, 0,
                  Phrase::of("%1 does not have the form For M5|Adr …|PI1 …|Hz …: transfer the file again, or "
                             "correct or delete the line",
                             quotation(line.text)));
  }

  /// Handles a line without the mark of the format; it is refused if it may be a sighting.
  void readOther(const TextLine& line) {
    const bool isSighting =
        line.text.find("|Hz") != std::string_view::npos || line.text.find("|V1") != std::string_view::npos;
    if (isSighting) return refuseLine(line);
    m_book.setAsideLine(line.text, line.number);
  }

  /// Reads a text line: a mark, or a heading of the lines that follow, such as the name of a program of the
  /// instrument. Angles in a text line, such as those of an adjustment, are not sightings.
  void readText(const Block& block, const std::vector<Value>& values, std::size_t line) {
    const std::string text = trimmed(block.text.substr(std::min<std::size_t>(block.text.size(), 3)));
    Recording& recording = m_book.recording();
    bool isHeading = text == "START" || text == "END";
    for (const Value& value : values) {
      if (value.type == "01")
        m_book.keep(recording.instrumentName, nameOf(value), Phrase::of("instrument"), line);
      if (value.type == "02")
        m_book.keep(recording.instrumentSerial, nameOf(value), Phrase::of("instrument"), line);
      if (value.type == "22") takePlaceOfPoint(value);
      isHeading = isHeading || (!value.type.empty() && text.empty());
    }
    if (text.empty() || isHeading) return;
    if (const auto mark = fieldMark(text)) return m_book.take(*mark);
    if (const auto station = stationMark(text)) return m_book.beginStation(*station, line);
    m_isSetUp = isSetUp(text);
    if (m_isSetUp) return m_book.beginStation(text + " " + std::to_string(++m_setUps), line);
    m_book.setAside(Phrase::of("the text %1", quotation(text)), line);
  }

  /// Is this a program that sets up the instrument with sightings of known points: KN STAT, UN STAT? EL STAT
  /// only gives the current station its height.
  static bool isSetUp(std::string_view text) { return text.ends_with(" STAT") && !text.starts_with("EL "); }

  /// The whole text of a value 01 or 02: these have no unit, so `M3 5"DR` is one name.
  static std::string nameOf(const Value& value) {
    return value.unit.empty() ? value.number : value.number + " " + value.unit;
  }

  void takePlaceOfPoint(const Value& value) {
    const Result<int> place = parseWhole(value.number);
    if (place && *place >= 1) m_placeOfPoint = static_cast<std::size_t>(*place - 1);
  }

  void readPoint(const Block& block, const std::vector<Value>& values, std::size_t line) {
    RecordedSighting sighting;
    sighting.line = line;
    takePoint(block, sighting);
    bool isSighting = false;
    for (const Value& value : values) {
      if (isCircleValue(value)) {
        isSighting = true;
        if (!takeAngle(value, line, sighting)) return;
      }
    }
    if (!isSighting) return readPointAlone(sighting, line);
    const bool hasHorizontal = sighting.columnOf(rowField(&Reading::horizontal)) > 0;
    if (!hasHorizontal || sighting.columnOf(rowField(&Reading::vertical)) == 0)
      return m_book.refuse(
          line, 0,
          hasHorizontal
              ? Phrase::of(
                    "has no vertical circle (V1): let the instrument record Hz and V, or delete the line")
              : Phrase::of(
                    "has no horizontal circle (Hz): let the instrument record Hz and V, or delete the line"));
    for (const Value& value : values)
      if (value.type == "SD" || value.type == "HD" || value.type == "D")
        m_book.setAside(Phrase::of("distance"), line);
    const bool isNamed = upperCase(sighting.row.point) == "0";
    if (m_book.add(std::move(sighting)) && isNamed && m_isSetUp) m_book.note(backsightZero, line);
  }

  /// Reads a point without angles. Code S marks the station, written before the sightings from the station.
  void readPointAlone(const RecordedSighting& point, std::size_t line) {
    const std::string& note = point.row.note;
    const bool isStation = note == "S" || note.ends_with(" S");
    if (isStation && !m_book.isStationUsed()) return m_book.beginStation(point.row.point, line);
    m_book.setAside(Phrase::of("a line without angles"), line);
  }

  void takePoint(const Block& block, RecordedSighting& sighting) const {
    const RowField& point = rowField(&Reading::point);
    constexpr std::size_t heading = 4;  // "PI1 "
    std::string_view text = block.text;
    text.remove_prefix(std::min(heading, text.size()));
    if (m_placeOfPoint && *m_placeOfPoint < text.size()) {
      const std::string name = trimmed(text.substr(*m_placeOfPoint, pointWidth));
      if (!name.empty()) {
        sighting.enter(point, name, block.column + heading + *m_placeOfPoint);
        sighting.row.note = trimmed(text.substr(0, *m_placeOfPoint));
        return;
      }
    }
    const std::vector<Block> words = wordsIn({text, block.column + heading});
    if (words.empty()) return;
    sighting.enter(point, std::string(words.back().text), words.back().column);
    sighting.row.note = trimmed(text.substr(0, text.rfind(words.back().text)));
  }

  bool takeAngle(const Value& value, std::size_t line, RecordedSighting& sighting) {
    const auto refuse = [&](const std::string& why) {
      m_book.refuse(line, value.column, why);
      return false;
    };
    const bool isHorizontal = value.type == "Hz";
    const RowField& circle = rowField(isHorizontal ? &Reading::horizontal : &Reading::vertical);
    if (sighting.columnOf(circle) > 0)
      return refuse(Phrase::of("%1 is a second reading of the same circle: delete one of the two",
                               quotation(value.type)));
    if (!isHorizontal && value.type != "V1" && value.type != "V3")
      return refuse(
          Phrase::of("%1 is neither a zenith angle (V1) nor a height angle (V3): set the instrument to one "
                     "of them and record again",
                     quotation(value.type)));
    const auto angle = exactAngle(value.number, value.unit);
    if (!angle)
      return refuse(Phrase::of("%1 is no angle in gon, DEG, DMS or mil: transfer the file again",
                               quotation(value.number + " " + value.unit)));
    if (!isHorizontal) {
      std::string& circleKind = m_book.recording().verticalCircle;
      const std::string own = value.type == "V1" ? "zenith" : "elevation";
      if (!circleKind.empty() && circleKind != own)
        return refuse(
            Phrase::of("“%1” is in a file that began with the other kind of vertical angle: import the two "
                       "kinds from separate files",
                       value.type));
      circleKind = own;
    }
    m_book.enter(sighting, circle, *angle, value.column);
    return true;
  }

  FieldBook m_book;
  bool m_isSetUp = false;                     ///< within a program that sets up the instrument
  std::size_t m_setUps = 0;                   ///< number of programs so far that set up the instrument
  std::optional<std::size_t> m_placeOfPoint;  ///< position in the text of a point, from 0
};

}  // namespace

bool looksLikeM5(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  constexpr std::string_view begin = "For M5|";
  return line.size() > begin.size() && line.starts_with("For") && (line[3] == ' ' || line[3] == '_') &&
         line.substr(4, 3) == "M5|";
}

Recording readM5(std::string_view text, const std::string& zeroPoint) {
  return M5Reader(zeroPoint).read(text);
}

}  // namespace alidade
