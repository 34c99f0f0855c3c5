#include "core/exchange/gsi_reader.h"

#include <algorithm>

#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/field_book.h"
#include "core/exchange/gsi_word.h"

namespace alidade {

namespace {

constexpr int pointIndex = 11, serialIndex = 12, typeIndex = 13, dateIndex = 17, horizontalIndex = 21,
              stationIndex = 16, verticalIndex = 22, slopeIndex = 31, horizontalDistanceIndex = 32,
              codeIndex = 41, codeNumberIndex = 42;

const GsiWord* wordOf(const std::vector<GsiWord>& words, int index) {
  const auto found =
      std::find_if(words.begin(), words.end(), [index](const GsiWord& word) { return word.index == index; });
  return found == words.end() ? nullptr : &*found;
}

/// DDMMYYYY as year-month-day; empty where it is none.
std::string dateOf(const std::string& digits) {
  const std::string full = std::string(digits.size() < 8 ? 8 - digits.size() : 0, '0') + digits;
  if (full.size() != 8 || !std::all_of(full.begin(), full.end(), isDigit)) return {};
  return full.substr(4) + "-" + full.substr(2, 2) + "-" + full.substr(0, 2);
}

/// Goes through a file block by block.
class GsiReader {
 public:
  explicit GsiReader(const std::string& zeroPoint) : m_book(zeroPoint) {}

  Recording read(std::string_view text) {
    bool wide = false;
    TextLines lines(text);
    while (const auto line = lines.next()) {
      wide = wide || line->text.starts_with('*');
      readLine(*line);
      if (m_book.isFull(line->number)) break;
    }
    return m_book.finish(wide ? "GSI-16" : "GSI-8");
  }

 private:
  void readLine(const TextLine& line) {
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return;
    if (std::string_view("#@?%").find(line.text[first]) != std::string_view::npos)
      return m_book.setAside(Phrase::of("the line %1", quotation(line.text.substr(first))), line.number);
    const auto parsed = gsiWords(line);
    if (const auto* problem = std::get_if<LineProblem>(&parsed))
      return m_book.refuse(problem->line, problem->column, problem->what);
    const auto& words = std::get<std::vector<GsiWord>>(parsed);
    if (wordOf(words, codeIndex)) {
      readCode(words, line.number);
    } else if (wordOf(words, horizontalIndex) || wordOf(words, verticalIndex)) {
      readSighting(words, line.number);
    } else {
      const GsiWord* point = tellsStation(words) ? wordOf(words, pointIndex) : nullptr;
      if (point) m_book.beginStation(gsiText(*point), line.number);
      for (const GsiWord& word : words)
        if (&word != point) readHeading(word, line.number);
    }
  }

  /// Coordinates of a station, or the height of the instrument.
  static bool tellsStation(const std::vector<GsiWord>& words) {
    return std::any_of(words.begin(), words.end(), [](const GsiWord& word) {
      return (word.index >= 84 && word.index <= 86) || word.index == 88;
    });
  }

  void readCode(const std::vector<GsiWord>& words, std::size_t line) {
    const std::string code = gsiText(*wordOf(words, codeIndex));
    const GsiWord* more = wordOf(words, codeNumberIndex);
    const std::string further = more ? gsiText(*more) : std::string();
    if (const auto station = stationMark(code, further)) return m_book.beginStation(*station, line);
    const auto mark = fieldMark(code, further);
    if (!mark) return m_book.setAside(Phrase::of("the code block %1", quotation(code)), line);
    m_book.take(*mark);
    for (const GsiWord& word : words)
      if (word.index != codeIndex && word.index != codeNumberIndex)
        m_book.setAside(gsiWordName(word.index), line);
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
    for (const GsiWord& word : words) {
      if (word.index == pointIndex && !point) {
        sighting.enter(rowField(&Reading::point), gsiText(word), word.column);
        point = true;
      } else if (const RowField* circle = circleOf(word); circle && sighting.columnOf(*circle) == 0) {
        if (!takeAngle(word, line, *circle, sighting)) return;
      } else if (word.index >= 71 && word.index <= 79) {
        addNote(sighting.row.note, gsiText(word));
      } else if (word.index == slopeIndex || word.index == horizontalDistanceIndex) {
        takeDistance(word, line, sighting);
      } else {
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
    m_book.add(std::move(sighting));
  }

  /// The circle that a word is of; null where it is of none.
  static const RowField* circleOf(const GsiWord& word) {
    if (word.index == horizontalIndex) return &rowField(&Reading::horizontal);
    return word.index == verticalIndex ? &rowField(&Reading::vertical) : nullptr;
  }

  bool takeAngle(const GsiWord& word, std::size_t line, const RowField& circle, RecordedSighting& sighting) {
    const auto angle = gsiAngle(word, line);
    if (const auto* problem = std::get_if<LineProblem>(&angle)) {
      m_book.refuse(problem->line, problem->column, problem->what);
      return false;
    }
    sighting.enter(circle, std::get<std::string>(angle), word.column);
    return true;
  }

  /// The slope distance where both are there.
  void takeDistance(const GsiWord& word, std::size_t line, RecordedSighting& sighting) {
    m_book.setBeside(gsiWordName(word.index), line);
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
};

}  // namespace

Recording readGsi(std::string_view text, const std::string& zeroPoint) {
  return GsiReader(zeroPoint).read(text);
}

}  // namespace alidade
