#include "core/exchange/zeiss_r_reader.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/exact_angle.h"
#include "core/exchange/field_book.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

struct ZeissValue {
  std::string type, number, unit;
};

/// Splits `Hz 107.1225 gon `; the type is empty if the block is empty.
ZeissValue zeissValue(std::string_view block) {
  const std::string text = trimmed(block);
  constexpr std::size_t typeLength = 2;
  if (text.size() < typeLength) return {};
  ZeissValue value{.type = trimmed(text.substr(0, typeLength)), .number = {}, .unit = {}};
  const std::string rest = trimmed(text.substr(typeLength));
  const std::size_t blank = std::min(rest.find_first_of(" \t"), rest.size());
  value.number = rest.substr(0, blank);
  value.unit = trimmed(rest.substr(blank));
  return value;
}

/// Reads a file line by line.
class ZeissRReader {
 public:
  explicit ZeissRReader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    m_book.readLines(text, [this](const TextLine& line) { readLine(line); });
    return m_book.finish(m_isR5 ? "R5" : "R4");
  }

 private:
  void readLine(const TextLine& line) {
    const std::string_view content = withoutIndent(line.text);
    if (content.empty() || content.starts_with("END")) return;
    if (!looksLikeZeissR(content))
      return m_book.setAside(Phrase::of("the line %1", quotation(content)), line.number);
    std::vector<std::string_view> blocks = separatedParts(content, '|');
    m_isR5 = m_isR5 || content[5] == '5';
    blocks.erase(blocks.begin());
    if (trimmed(blocks[0]).starts_with("Adr")) blocks.erase(blocks.begin());
    if (blocks.empty()) return;
    const std::string_view what = blocks[0];
    std::vector<ZeissValue> values;
    for (std::size_t i = 1; i < std::min<std::size_t>(blocks.size(), 4); ++i)
      values.push_back(zeissValue(blocks[i]));
    if (isOneOf(what.substr(0, 2), {"TR", "TI", "TO", "TN"})) return readText(what, line.number);
    readPoint(what, values, line.number);
  }

  /// Reads a text line: a mark, or a text to be listed. The angles of an adjustment are not sightings.
  void readText(std::string_view what, std::size_t line) {
    const std::string text = trimmed(what.substr(std::min<std::size_t>(what.size(), 3)));
    if (text.empty()) return;
    if (const auto mark = fieldMark(text)) return m_book.take(*mark);
    m_book.setAside(Phrase::of("the text %1", quotation(text)), line);
  }

  void readPoint(std::string_view what, const std::vector<ZeissValue>& values, std::size_t line) {
    const auto isVertical = [](const ZeissValue& value) { return value.type.starts_with('V'); };
    const auto horizontal = std::ranges::find(values, "Hz", &ZeissValue::type);
    const auto vertical = std::ranges::find_if(values, isVertical);
    if (horizontal == values.end() && vertical == values.end())
      return m_book.setAside(Phrase::of("a line without angles"), line);
    if (horizontal == values.end() || vertical == values.end())
      return m_book.setAside(Phrase::of("an observation without one of the circles"), line);
    RecordedSighting sighting;
    sighting.line = line;
    takeName(what, sighting);
    if (!takeAngle(*horizontal, line, rowField(&Reading::horizontal), sighting)) return;
    if (!takeCircleKind(vertical->type, line)) return;
    if (!takeAngle(*vertical, line, rowField(&Reading::vertical), sighting)) return;
    for (const ZeissValue& value : values)
      if (isOneOf(value.type, {"SD", "HD", "D", "E"})) m_book.setAside(Phrase::of("distance"), line);
    m_book.add(std::move(sighting));
  }

  static void takeName(std::string_view what, RecordedSighting& sighting) {
    constexpr std::size_t kind = 3, code = 3, width = 7;
    const std::string_view name = what.substr(std::min(kind, what.size()));
    const bool isFixed = name.size() <= width && name.size() > code;
    const std::string all = trimmed(name);
    const std::size_t blank = all.find_last_of(" \t");
    sighting.row.point = isFixed ? trimmed(name.substr(code)) : all.substr(blank + 1);
    sighting.row.note = isFixed                      ? trimmed(name.substr(0, code))
                        : blank == std::string::npos ? std::string()
                                                     : trimmed(all.substr(0, blank));
  }

  bool takeAngle(const ZeissValue& value, std::size_t line, const RowField& circle,
                 RecordedSighting& sighting) {
    const auto angle = exactAngle(value.number, value.unit);
    if (angle) {
      m_book.enter(sighting, circle, *angle, 0);
      return true;
    }
    m_book.refuse(line, 0,
                  Phrase::of("%1 is no angle in gon, DEG, DMS or mil: transfer the file again",
                             quotation(trimmed(value.number + " " + value.unit))));
    return false;
  }

  bool takeCircleKind(const std::string& type, std::size_t line) {
    const bool isZenith = type == "V1";
    std::string& known = m_book.recording().verticalCircle;
    const std::string own = isZenith ? "zenith" : "elevation";
    if (!isZenith && type != "V3") {
      m_book.refuse(line, 0,
                    Phrase::of("%1 is neither a zenith angle (V1) nor a height angle (V3): set the "
                               "instrument to one of them and record again",
                               quotation(type)));
      return false;
    }
    if (!known.empty() && known != own) {
      m_book.refuse(line, 0,
                    Phrase::of("“%1” is in a file that began with the other kind of vertical angle: import "
                               "the two kinds from separate files",
                               type));
      return false;
    }
    known = own;
    return true;
  }

  FieldBook m_book;
  bool m_isR5 = false;
};

}  // namespace

bool looksLikeZeissR(std::string_view line) {
  line = withoutIndent(line);
  constexpr std::size_t mark = 7;  // For R5|
  return line.size() > mark && line.starts_with("For") && (line[3] == ' ' || line[3] == '_') &&
         (line.substr(4, 3) == "R4|" || line.substr(4, 3) == "R5|");
}

Recording readZeissR(std::string_view text, const std::string& zeroPoint) {
  return ZeissRReader(zeroPoint).read(text);
}

}  // namespace alidade
