#include "core/exchange/gsi_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/field_book.h"
#include "core/exchange/gsi_word.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr int pointIndex = 11, serialIndex = 12, typeIndex = 13, dateIndex = 17, horizontalIndex = 21,
              stationIndex = 16, verticalIndex = 22, slopeIndex = 31, horizontalDistanceIndex = 32,
              codeIndex = 41, codeNumberIndex = 42;

constexpr const char* keyedIn =
    PHRASE_LATER("Phrase", "angles keyed in by hand, not measured: %1, first in line %2");
constexpr const char* workedOut = PHRASE_LATER(
    "Phrase", "angles that a program of the instrument worked out, not measured: %1, first in line %2");
constexpr const char* oddWidths =
    PHRASE_LATER("Phrase", "words with neither 8 nor 16 characters, used unchanged: %1, first in line %2");

const GsiWord* wordOf(const std::vector<GsiWord>& words, int index) {
  const auto found =
      std::find_if(words.begin(), words.end(), [index](const GsiWord& word) { return word.index == index; });
  return found == words.end() ? nullptr : &*found;
}

/// Converts DDMMYYYY to year-month-day; empty if it is not a date.
std::string dateOf(const std::string& digits) {
  const std::string full = std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits;
  if (full.size() != 8 || !std::all_of(full.begin(), full.end(), isDigit)) return {};
  return full.substr(4) + "-" + full.substr(2, 2) + "-" + full.substr(0, 2);
}

/// Reads a file block by block.
class GsiReader {
 public:
  explicit GsiReader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    bool wide = false;
    m_book.readLines(text, [&](const TextLine& line) {
      wide = wide || line.text.starts_with('*');
      readLine(line);
    });
    return m_book.finish(wide ? "GSI-16" : "GSI-8");
  }

 private:
  void readLine(const TextLine& line) {
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return;
    if (std::string_view("#@?%").find(line.text[first]) != std::string_view::npos)
      return m_book.setAside(Phrase::of("the line %1", quotation(line.text.substr(first))), line.number);
    GsiBlocks blocks(line);
    while (const auto block = blocks.next()) {
      if (const auto problem = tornProblem(*block, line.number)) {
        m_book.refuse(problem->line, problem->column, problem->what);
      } else {
        for (const GsiWord& word : block->torn) setAsideText(word, line);
        readBlock(block->words, line.number);
      }
      if (m_book.isFull(line.number)) return;
    }
  }

  /// Lists text outside the words that does not matter, such as a heading or a check sum.
  void setAsideText(const GsiWord& word, const TextLine& line) {
    if (trimmed(line.text) == word.data)
      m_book.setAsideLine(word.data, line.number);
    else
      m_book.setAsidePart(word.data, line.number);
  }

  /// Returns the reason why a block with a torn word cannot be used; absent if the word does not matter.
  static std::optional<LineProblem> tornProblem(const GsiBlock& block, std::size_t line) {
    const bool isSighting = wordOf(block.words, horizontalIndex) || wordOf(block.words, verticalIndex);
    for (const GsiWord& word : block.torn) {
      const bool isCircle = word.index == horizontalIndex || word.index == verticalIndex ||
                            (wordOf(block.words, pointIndex) && isCutCircle(word.data));
      if (isCircle || (isSighting && word.index == pointIndex) || isTornMark(word))
        return LineProblem{line, word.column,
                           Phrase::of("%1 is no GSI word such as 21.102+17920860: transfer the file again, "
                                      "or correct or delete the line",
                                      quotation(word.data))};
    }
    return std::nullopt;
  }

  /// Is the text the beginning of a circle word, such as "21.3" at the end of an incomplete file?
  static bool isCutCircle(std::string_view text) {
    constexpr std::size_t ofWord = 7;
    return text.size() < ofWord && (text.starts_with("21.") || text.starts_with("22.")) &&
           text.find_first_not_of("0123456789.+-") == std::string_view::npos;
  }

  /// Is the torn word a code whose text marks the axis, the round, the zero or a station?
  static bool isTornMark(const GsiWord& word) {
    const std::size_t sign = word.data.find('+');
    if (word.index != codeIndex || sign == std::string_view::npos) return false;
    const std::string text = gsiText({.data = word.data.substr(sign + 1)});
    return fieldMark(text) || stationMark(text);
  }

  void readBlock(const std::vector<GsiWord>& words, std::size_t line) {
    const bool isSighting = wordOf(words, horizontalIndex) || wordOf(words, verticalIndex);
    noteWidths(words, line);
    if (wordOf(words, codeIndex)) readCode(words, line, isSighting);
    if (isSighting) return readSighting(words, line);
    if (wordOf(words, codeIndex)) return;
    const GsiWord* point = hasStation(words) ? wordOf(words, pointIndex) : nullptr;
    if (point) m_book.beginStation(gsiText(*point), line);
    if (!point && wordOf(words, pointIndex)) m_book.dropZeroMark();  // a sighting without angles
    for (const GsiWord& word : words)
      if (&word != point) readHeading(word, line);
  }

  void noteWidths(const std::vector<GsiWord>& words, std::size_t line) {
    for (const GsiWord& word : words)
      if (!word.isWhole && isText(word.index)) m_book.note(oddWidths, line);
  }

  /// Is the word's text used unchanged: point, instrument, station, date, code or remark?
  static bool isText(int index) {
    return (index >= pointIndex && index <= dateIndex) || index == codeIndex || index == codeNumberIndex ||
           (index >= 71 && index <= 79);
  }

  /// Does the block hold coordinates of a station or the height of the instrument?
  static bool hasStation(const std::vector<GsiWord>& words) {
    return std::any_of(words.begin(), words.end(), [](const GsiWord& word) {
      return (word.index >= 84 && word.index <= 86) || word.index == 88;
    });
  }

  void readCode(const std::vector<GsiWord>& words, std::size_t line, bool isSighting) {
    const std::string code = gsiText(*wordOf(words, codeIndex));
    const GsiWord* more = wordOf(words, codeNumberIndex);
    const std::string further = more ? gsiText(*more) : std::string();
    if (const auto station = stationOf(code, further)) return m_book.beginStation(*station, line);
    const auto mark = fieldMark(code, further);
    if (isSighting && mark && isBareAxis(code)) {
      m_hasAxisInSightings = m_hasAxisInSightings || mark->number == "180";
      if (!m_hasAxisInSightings) return;  // 0 is what an instrument writes without a code
    }
    if (!mark) return m_book.setAside(Phrase::of("the code block %1", quotation(code)), line);
    m_book.take(*mark);
    if (isSighting) return;
    for (const GsiWord& word : words)
      if (!isOfCode(word)) m_book.setAside(gsiWordName(word.index), line);
  }

  static bool isBareAxis(const std::string& code) {
    return code.find_first_not_of("0123456789") == std::string::npos;
  }

  static bool isOfCode(const GsiWord& word) {
    return word.index == codeIndex || word.index == codeNumberIndex;
  }

  /// The station that the code block begins. Total stations write code 21, older instruments 2, with the
  /// station's name in word 42.
  static std::optional<std::string> stationOf(const std::string& code, const std::string& further) {
    const bool isSetUp = (code == "21" || code == "2") && !further.empty();
    return isSetUp ? std::optional(further) : stationMark(code, further);
  }

  void readHeading(const GsiWord& word, std::size_t line) {
    const std::string text = gsiText(word), name = gsiWordName(word.index);
    Recording& recording = m_book.recording();
    if (word.index == serialIndex) {
      m_book.keep(recording.instrumentSerial, text, name, line);
    } else if (word.index == stationIndex) {
      m_book.beginStation(text, line);
    } else if (word.index == typeIndex) {
      m_book.keep(recording.instrumentName, text, name, line);
    } else if (const std::string date = dateOf(text); word.index == dateIndex && !date.empty()) {
      m_book.keep(recording.measuredOn, date, name, line);
    } else if (word.index == pointIndex) {
      m_book.setAside(Phrase::of("point %1 without angles", quotation(text)), line);
    } else {
      m_book.setAside(name, line);
    }
  }

  void readSighting(const std::vector<GsiWord>& words, std::size_t line) {
    RecordedSighting sighting;
    sighting.line = line;
    bool point = false;
    std::optional<GsiPoint> sign;
    for (const GsiWord& word : words)
      if (!sign && circleOf(word)) sign = gsiPoint(word);
    for (const GsiWord& word : words) {
      if (word.index == pointIndex && !point) {
        sighting.enter(rowField(&Reading::point), gsiText(word), word.column);
        point = true;
      } else if (const RowField* circle = circleOf(word)) {
        if (!takeAngle(word, sign, *circle, sighting)) return;
      } else if (word.index >= 71 && word.index <= 79) {
        addNote(sighting.row.note, gsiText(word));
      } else if (word.index == slopeIndex || word.index == horizontalDistanceIndex) {
        takeDistance(word, line, sighting);
      } else if (!isOfCode(word)) {
        readHeading(word, line);
      }
    }
    const bool hasHorizontal = sighting.columnOf(rowField(&Reading::horizontal)) > 0;
    if (!hasHorizontal || sighting.columnOf(rowField(&Reading::vertical)) == 0) {
      return m_book.refuse(
          line, 0,
          hasHorizontal ? Phrase::of("has no vertical circle (word 22): add the word or delete the line")
                        : Phrase::of("has no horizontal circle (word 21): add the word or delete the line"));
    }
    noteInput(words, line);
    m_book.add(std::move(sighting));
  }

  /// Adds remarks on angles that were keyed in or calculated.
  void noteInput(const std::vector<GsiWord>& words, std::size_t line) {
    for (const GsiWord& word : words)
      if (circleOf(word) && (word.input == '1' || word.input == '4'))
        m_book.note(word.input == '1' ? keyedIn : workedOut, line);
  }

  /// The field of the circle whose reading the word is; null for other words.
  static const RowField* circleOf(const GsiWord& word) {
    if (word.index == horizontalIndex) return &rowField(&Reading::horizontal);
    return word.index == verticalIndex ? &rowField(&Reading::vertical) : nullptr;
  }

  bool takeAngle(const GsiWord& word, std::optional<GsiPoint> sign, const RowField& circle,
                 RecordedSighting& sighting) {
    auto angle = gsiExactAngle(word, sighting.line, sign);
    if (sighting.columnOf(circle) > 0)
      angle =
          LineProblem{sighting.line, word.column,
                      Phrase::of("is a second reading of its circle in one block: delete one of the two")};
    if (const auto* problem = std::get_if<LineProblem>(&angle)) {
      m_book.refuse(problem->line, problem->column, problem->what);
      return false;
    }
    m_book.enter(sighting, circle, std::get<ExactAngle>(std::move(angle)), word.column);
    return true;
  }

  /// Enters the distance; the slope distance if the block has both.
  void takeDistance(const GsiWord& word, std::size_t line, RecordedSighting& sighting) {
    if (!word.isWhole) return m_book.setAside(gsiWordName(word.index), line);
    m_book.setAsideForCheck(gsiWordName(word.index), line);
    const auto metres = gsiMetres(word);
    const bool isSlope = word.index == slopeIndex;
    if (!metres || !(*metres > 0) || (!isSlope && sighting.distanceM > 0)) return;
    sighting.distanceM = *metres;
    sighting.isDistanceHorizontal = !isSlope;
  }

  static void addNote(std::string& note, const std::string& text) {
    if (text.empty() || text == "0") return;
    if (!note.empty()) note += ' ';
    note += text;
  }

  FieldBook m_book;
  bool m_hasAxisInSightings = false;  ///< sightings state the axis as a bare number
};

}  // namespace

Recording readGsi(std::string_view text, const std::string& zeroPoint) {
  return GsiReader(zeroPoint).read(text);
}

}  // namespace alidade
