#include "core/exchange/gsi_reader.h"

#include <algorithm>
#include <map>

#include "core/base/limits.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/gsi_word.h"

namespace alidade {

namespace {

constexpr int pointIndex = 11, serialIndex = 12, typeIndex = 13, dateIndex = 17, horizontalIndex = 21,
              verticalIndex = 22, codeIndex = 41, codeNumberIndex = 42;

std::string upperCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

const GsiWord* wordOf(const std::vector<GsiWord>& words, int index) {
  const auto found =
      std::find_if(words.begin(), words.end(), [index](const GsiWord& word) { return word.index == index; });
  return found == words.end() ? nullptr : &*found;
}

/// "000180" as "180", "" as "0".
std::string withoutZeros(const std::string& digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

/// A code block in words: `name` in capitals and the number behind it.
struct Code {
  std::string name, number;
};

Code codeOf(const std::vector<GsiWord>& words) {
  const std::string text = upperCase(gsiText(*wordOf(words, codeIndex)));
  const std::size_t digits = text.find_last_not_of("0123456789") + 1;
  Code code{text.substr(0, digits), text.substr(digits)};
  const GsiWord* more = wordOf(words, codeNumberIndex);
  if (code.number.empty() && more) code.number = gsiText(*more);
  if (code.name == "POS" || code.name == "POSITION") code.name = "AXIS";
  const bool isAxis = code.name.empty() && (withoutZeros(code.number) == "0" || code.number == "180");
  if (isAxis) code.name = "AXIS";
  return code;
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
  explicit GsiReader(const std::string& zeroPoint) : m_zeroPoint(upperCase(zeroPoint)) {}

  Recording read(std::string_view text) {
    bool wide = false;
    TextLines lines(text);
    while (const auto line = lines.next()) {
      wide = wide || line->text.starts_with('*');
      readLine(*line);
      if (m_recording.problems.size() >= limits::mostProblems) break;
      if (m_recording.sightings.size() <= limits::mostRows) continue;
      m_recording.problems = {{line->number, 0, limits::beyondTheRows()}};
      break;
    }
    m_recording.format = wide ? "GSI-16" : "GSI-8";
    for (const auto& [what, use] : m_unused) m_recording.unused.push_back(what + sentence(use));
    return std::move(m_recording);
  }

 private:
  struct Unused {
    std::size_t count = 0, firstLine = 0;
  };

  static std::string sentence(const Unused& unused) {
    const std::string first = "line " + std::to_string(unused.firstLine);
    if (unused.count == 1) return " is not used: " + first;
    return " is not used: " + std::to_string(unused.count) + " times, first in " + first;
  }

  void setAside(const std::string& what, std::size_t line) {
    const bool isNew = m_unused.size() >= limits::mostKinds && !m_unused.contains(what);
    Unused& use = m_unused[isNew ? "what else has no place in a session" : what];
    if (use.count++ == 0) use.firstLine = line;
  }

  void readLine(const TextLine& line) {
    const std::size_t first = line.text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return;
    if (std::string_view("#@?%").find(line.text[first]) != std::string_view::npos)
      return setAside("the line " + quotation(line.text.substr(first)), line.number);
    const auto parsed = gsiWords(line);
    if (const auto* problem = std::get_if<LineProblem>(&parsed)) {
      m_recording.problems.push_back(*problem);
      return;
    }
    const auto& words = std::get<std::vector<GsiWord>>(parsed);
    if (wordOf(words, codeIndex)) {
      readCode(words, line.number);
    } else if (wordOf(words, horizontalIndex) || wordOf(words, verticalIndex)) {
      readSighting(words, line.number);
    } else {
      for (const GsiWord& word : words) readHeading(word, line.number);
    }
  }

  void readCode(const std::vector<GsiWord>& words, std::size_t line) {
    const Code code = codeOf(words);
    const std::string number = withoutZeros(code.number);
    if (code.name == "AXIS" && (number == "0" || number == "180")) {
      m_axis = number;
      m_round.clear();
    } else if (code.name == "ROUND" && !code.number.empty()) {
      m_round = number;
    } else if (code.name == "ZERO") {
      m_zeroComes = true;
    } else {
      setAside("the code block " + quotation(gsiText(*wordOf(words, codeIndex))), line);
      return;
    }
    for (const GsiWord& word : words)
      if (word.index != codeIndex && word.index != codeNumberIndex) setAside(gsiWordName(word.index), line);
  }

  void readHeading(const GsiWord& word, std::size_t line) {
    const std::string text = gsiText(word);
    if (word.index == serialIndex) {
      keep(m_recording.instrumentSerial, text, word, line);
    } else if (word.index == typeIndex) {
      keep(m_recording.instrumentName, text, word, line);
    } else if (const std::string date = dateOf(text); word.index == dateIndex && !date.empty()) {
      keep(m_recording.measuredOn, date, word, line);
    } else if (word.index == pointIndex) {
      setAside("point " + quotation(text) + " without angles", line);
    } else {
      setAside(gsiWordName(word.index), line);
    }
  }

  /// The first value counts; another one is listed.
  void keep(std::string& value, const std::string& text, const GsiWord& word, std::size_t line) {
    if (value.empty() || value == text) {
      value = text;
    } else {
      setAside(gsiWordName(word.index) + " " + quotation(text), line);
    }
  }

  void readSighting(const std::vector<GsiWord>& words, std::size_t line) {
    RecordedSighting sighting;
    sighting.line = line;
    sighting.axis.text = m_axis;
    sighting.row.round = m_round;
    bool point = false;
    for (const GsiWord& word : words) {
      if (word.index == pointIndex && !point) {
        sighting.enter(rowField(&Reading::point), gsiText(word), word.column);
        point = true;
      } else if (const RowField* circle = circleOf(word); circle && sighting.columnOf(*circle) == 0) {
        if (!takeAngle(word, line, *circle, sighting)) return;
      } else if (word.index >= 71 && word.index <= 79) {
        addNote(sighting.row.note, gsiText(word));
      } else {
        readHeading(word, line);
      }
    }
    const bool hasHorizontal = sighting.columnOf(rowField(&Reading::horizontal)) > 0;
    if (!hasHorizontal || sighting.columnOf(rowField(&Reading::vertical)) == 0) {
      const std::string missing = hasHorizontal ? "vertical circle (word 22)" : "horizontal circle (word 21)";
      m_recording.problems.push_back({line, 0, "has no " + missing + ": add the word or delete the line"});
      return;
    }
    const std::string name = upperCase(sighting.row.point);
    sighting.isZero =
        m_zeroComes || (m_zeroPoint.empty() ? name == "0" || name == "ZERO" : name == m_zeroPoint);
    m_zeroComes = false;
    m_recording.sightings.push_back(std::move(sighting));
  }

  /// The circle that a word is of; null where it is of none.
  static const RowField* circleOf(const GsiWord& word) {
    if (word.index == horizontalIndex) return &rowField(&Reading::horizontal);
    return word.index == verticalIndex ? &rowField(&Reading::vertical) : nullptr;
  }

  bool takeAngle(const GsiWord& word, std::size_t line, const RowField& circle, RecordedSighting& sighting) {
    const auto angle = gsiAngle(word, line);
    if (const auto* problem = std::get_if<LineProblem>(&angle)) {
      m_recording.problems.push_back(*problem);
      return false;
    }
    sighting.enter(circle, std::get<std::string>(angle), word.column);
    return true;
  }

  static void addNote(std::string& note, const std::string& text) {
    if (text.empty() || text == "0") return;
    if (!note.empty()) note += ' ';
    note += text;
  }

  std::string m_zeroPoint;
  std::string m_axis, m_round;
  bool m_zeroComes = false;
  std::map<std::string, Unused> m_unused;
  Recording m_recording;
};

}  // namespace

Recording readGsi(std::string_view text, const std::string& zeroPoint) {
  return GsiReader(zeroPoint).read(text);
}

}  // namespace alidade
