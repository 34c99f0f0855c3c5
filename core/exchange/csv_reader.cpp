#include "core/exchange/csv_reader.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/csv_text.h"

namespace alidade {

namespace {

/// What a column of the table holds.
struct Column {
  const RowField* field;  ///< of the row; null: how the axis stood, or the how many-th time
  bool isTurn = false;

  bool operator==(const Column&) const = default;
};

constexpr std::string_view axisHeadings = "axis position pos axisposition rotation", turnHeadings = "turn";

struct Heading {
  std::optional<Column> column;
  AngleUnit unit = AngleUnit::Unstated;
  std::string verticalCircle;  ///< that the name speaks of; may be empty
};

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The words of a column's name: letters and signs other than separators, in small letters.
std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words;
  bool inWord = false;
  for (const char c : lowerCase(name)) {
    const bool parts = std::string_view(" _-./:[](){}").find(c) != std::string_view::npos;
    if (!parts && !inWord) words.emplace_back();
    if (!parts) words.back() += c;
    inWord = !parts;
  }
  return words;
}

std::optional<AngleUnit> unitNamed(std::string_view word) {
  if (isOneOf(word, {"gon", "grad", "gons", "g"})) return AngleUnit::Gon;
  if (isOneOf(word, {"deg", "degree", "degrees", "°", "dd"})) return AngleUnit::Degrees;
  if (isOneOf(word, {"dms", "dmmss", "mmss", "ddmmss", "dddmmss"})) return AngleUnit::Dms;
  return std::nullopt;
}

/// Is it one of these words with blanks between them?
bool isAmong(std::string_view words, std::string_view word) {
  return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

std::optional<Column> columnNamed(std::string_view word) {
  if (isAmong(axisHeadings, word)) return Column{nullptr};
  if (isAmong(turnHeadings, word)) return Column{nullptr, true};
  for (const RowField& field : rowFields)
    if (isAmong(field.headings, word)) return Column{&field};
  return std::nullopt;
}

Heading headingOf(const std::string& name) {
  Heading heading;
  bool counts = false, strange = false;
  for (const std::string& word : wordsOf(name)) {
    if (const auto column = columnNamed(word); column && !heading.column) {
      heading.column = column;
      if (word == "elevation") heading.verticalCircle = "elevation";
      if (word == "zenith" || word == "zenithdistance") heading.verticalCircle = "zenith";
    } else if (const auto unit = unitNamed(word)) {
      heading.unit = *unit;
    } else if (isOneOf(word, {"no", "nr", "number", "id", "name"})) {
      counts = true;
    } else if (!column && !isOneOf(word, {"angle", "circle", "reading", "readings", "of", "the", "typed"})) {
      strange = true;
    }
  }
  if (!heading.column && counts) heading.column = Column{&rowField(&Reading::point)};
  if (strange) heading.column.reset();
  return heading;
}

std::string titleOf(Column column) {
  return column.field ? std::string(column.field->key) : column.isTurn ? "turn" : "axis";
}

/// Goes through a table row by row.
class CsvReader {
 public:
  CsvReader(AngleUnit unit, const std::string& zeroPoint) : m_unit(unit), m_zeroPoint(lowerCase(zeroPoint)) {
    if (m_zeroPoint.empty()) m_zeroPoint = "zero";
  }

  Recording read(std::string_view text) {
    m_recording.format = "CSV";
    CsvTable table(text);
    std::vector<std::string> names;
    while (const auto row = table.next()) {
      if (row->isRemark) {
        takeRemark(*row);
      } else if (names.empty()) {
        for (const CsvCell& cell : row->cells) names.push_back(cell.text);
        if (!readHeadings(*row)) return std::move(m_recording);
      } else {
        readRow(*row);
      }
      if (m_recording.problems.size() >= limits::mostProblems) break;
    }
    if (const auto& problem = table.problem()) {
      m_recording.sightings.clear();
      m_recording.problems = {*problem};
      return std::move(m_recording);
    }
    if (names.empty()) return std::move(m_recording);
    for (std::size_t i = 0; i < m_unusedCells.size(); ++i)
      if (m_unusedCells[i] > 0)
        m_recording.unused.push_back("the column " + quotation(names[i]) +
                                     " is not used: " + counted(m_unusedCells[i], "value"));
    for (const CsvRow& row : m_earlyRemarks)
      if (holdsReading(row)) tellOfRemark(row.line);
    for (const std::size_t line : m_remarksWithReading) tellOfRemark(line);
    return std::move(m_recording);
  }

 private:
  void refuse(std::size_t line, std::size_t column, const std::string& what) {
    m_recording.problems.push_back({line, column, what});
  }

  /// Before the columns are known it waits; a thousand are more than any heading has.
  void takeRemark(const CsvRow& row) {
    constexpr std::size_t mostEarly = 1000;
    if (m_headings.empty()) {
      if (m_earlyRemarks.size() < mostEarly) m_earlyRemarks.push_back(row);
    } else if (holdsReading(row)) {
      m_remarksWithReading.push_back(row.line);
    }
  }

  void tellOfRemark(std::size_t line) {
    m_recording.unused.push_back("line " + std::to_string(line) +
                                 " begins with # and is not used, though it holds a reading");
  }

  bool has(Column column) const {
    return std::any_of(m_headings.begin(), m_headings.end(),
                       [column](const Heading& heading) { return heading.column == column; });
  }

  bool readHeadings(const CsvRow& row) {
    for (const CsvCell& cell : row.cells) {
      const Heading heading = headingOf(cell.text);
      if (heading.column && has(*heading.column)) {
        refuse(row.line, cell.column,
               quotation(cell.text) + " is a second column for “" + titleOf(*heading.column) +
                   "”: rename or remove one of the two");
        return false;
      }
      m_headings.push_back(heading);
      if (!heading.verticalCircle.empty()) m_recording.verticalCircle = heading.verticalCircle;
    }
    m_unusedCells.resize(m_headings.size());
    for (const RowField& field : rowFields) {
      if (!field.remedy || has({&field})) continue;
      refuse(row.line, 0,
             "no column is named “" + titleOf({&field}) +
                 "”: begin with a row of names such as axis;point;face;horizontal;vertical");
      return false;
    }
    return true;
  }

  void readRow(const CsvRow& row) {
    RecordedSighting sighting;
    sighting.line = row.line;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const CsvCell& cell = row.cells[i];
      if (cell.text.empty()) continue;
      if (i >= m_headings.size())
        return refuse(row.line, cell.column,
                      quotation(cell.text) +
                          " stands beyond the last named column: name its column, or put "
                          "double quotes around the entry that holds a separator");
      if (!m_headings[i].column)
        ++m_unusedCells[i];
      else if (!readCell(m_headings[i], cell, sighting))
        return refuse(row.line, cell.column,
                      quotation(cell.text) + (m_headings[i].column->isTurn
                                                  ? " is no turn: turns of the axis count from 1"
                                                  : " is neither yes nor no: type one of them"));
    }
    sighting.isZero = lowerCase(sighting.row.point) == m_zeroPoint;
    m_recording.sightings.push_back(std::move(sighting));
  }

  /// Of a row that was set aside: are both circles read in it?
  bool holdsReading(const CsvRow& row) const {
    const auto isReadable = [&](std::size_t i) {
      const AngleUnit unit = m_headings[i].unit == AngleUnit::Unstated ? m_unit : m_headings[i].unit;
      return static_cast<bool>(parseAngle(withUnit(row.cells[i].text, unit)));
    };
    int circles = 0;
    for (std::size_t i = 0; i < std::min(row.cells.size(), m_headings.size()); ++i) {
      const auto column = m_headings[i].column;
      const bool isCircle = column && column->field && column->field->remedy;
      if (isCircle && isReadable(i)) ++circles;
    }
    return circles == 2;
  }

  /// False where the cell is to count or to say yes or no, and does not.
  bool readCell(const Heading& heading, const CsvCell& cell, RecordedSighting& sighting) {
    const RowField* field = heading.column->field;
    if (heading.column->isTurn) {
      const Result<int> turn = parseWhole(cell.text);
      if (!turn || *turn < 1) return false;
      sighting.time = *turn;
      m_recording.tellsTurns = true;
    } else if (!field) {
      sighting.axis = {axisOf(fromPlainCell(cell.text)), cell.column};
    } else if (field->text) {
      sighting.enter(*field, textOf(*field, heading.unit, fromPlainCell(cell.text)), cell.column);
    } else {
      const auto flag = flagOf(cell.text);
      sighting.row.*field->flag = flag.value_or(false);
      return flag.has_value();
    }
    return true;
  }

  std::string textOf(const RowField& field, AngleUnit unit, const std::string& cell) const {
    if (isAngle(field)) return withUnit(cell, unit == AngleUnit::Unstated ? m_unit : unit);
    return field.text == &Reading::face ? faceOf(cell) : cell;
  }

  /// "180°" as "180".
  static std::string axisOf(const std::string& text) {
    constexpr std::string_view degree = "°";
    return text.ends_with(degree) ? text.substr(0, text.size() - degree.size()) : text;
  }

  static std::optional<bool> flagOf(const std::string& text) {
    const std::string flag = lowerCase(text);
    if (isOneOf(flag, {"1", "yes", "true", "x"})) return true;
    if (isOneOf(flag, {"0", "no", "false"})) return false;
    return std::nullopt;
  }

  static std::string faceOf(const std::string& text) {
    const std::string face = lowerCase(text);
    if (isOneOf(face, {"i", "l", "left", "f1", "cl"})) return "1";
    if (isOneOf(face, {"ii", "r", "right", "f2", "cr"})) return "2";
    return text;
  }

  AngleUnit m_unit;
  std::string m_zeroPoint;
  std::vector<Heading> m_headings;
  std::vector<std::size_t> m_unusedCells;
  std::vector<CsvRow> m_earlyRemarks;             ///< before the row of names
  std::vector<std::size_t> m_remarksWithReading;  ///< lines of those after it
  Recording m_recording;
};

}  // namespace

Recording readCsv(std::string_view text, AngleUnit unit, const std::string& zeroPoint) {
  return CsvReader(unit, zeroPoint).read(text);
}

}  // namespace alidade
