#include "core/exchange/csv_reader.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"

namespace alidade {

namespace {

enum class Column { Axis, Point, Round, Face, Horizontal, Vertical, Slider, Note, Excluded };

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

struct Synonym {
  Column column;
  std::initializer_list<std::string_view> words;
};

std::optional<Column> columnNamed(std::string_view word) {
  static const std::array<Synonym, 9> synonyms = {{
      {Column::Axis, {"axis", "position", "pos", "axisposition", "rotation"}},
      {Column::Point, {"point", "points", "pt", "ptno", "target", "#"}},
      {Column::Round, {"round", "rounds", "set", "series"}},
      {Column::Face, {"face", "side", "lage"}},
      {Column::Horizontal, {"horizontal", "hz", "h", "ha", "hor", "alpha", "α", "direction"}},
      {Column::Vertical,
       {"vertical", "v", "va", "vert", "beta", "β", "zenith", "zenithdistance", "elevation"}},
      {Column::Slider, {"slider", "s", "coordinate"}},
      {Column::Note, {"note", "notes", "remark", "remarks", "comment", "comments"}},
      {Column::Excluded, {"excluded", "exclude", "skip"}},
  }};
  for (const Synonym& synonym : synonyms)
    if (isOneOf(word, synonym.words)) return synonym.column;
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
  if (!heading.column && counts) heading.column = Column::Point;
  if (strange) heading.column.reset();
  return heading;
}

const char* titleOf(Column column) {
  constexpr std::array titles = {"axis",     "point",  "round", "face",    "horizontal",
                                 "vertical", "slider", "note",  "excluded"};
  return titles.at(static_cast<std::size_t>(column));
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
    for (const Column needed : {Column::Horizontal, Column::Vertical}) {
      if (has(needed)) continue;
      refuse(row.line, 0,
             std::string("no column is named “") + titleOf(needed) +
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
      if (m_headings[i].column == Column::Excluded) {
        const auto excluded = flagOf(cell.text);
        if (!excluded)
          return refuse(row.line, cell.column,
                        quotation(cell.text) + " is neither yes nor no: type one of them");
        sighting.excluded = *excluded;
      } else if (m_headings[i].column) {
        readCell(*m_headings[i].column, m_headings[i].unit, cell, sighting);
      } else {
        ++m_unusedCells[i];
      }
    }
    sighting.isZero = lowerCase(sighting.point.text) == m_zeroPoint;
    m_recording.sightings.push_back(std::move(sighting));
  }

  /// Of a row that was set aside: are both circles read in it?
  bool holdsReading(const CsvRow& row) const {
    const auto isAngle = [&](std::size_t i) {
      const AngleUnit unit = m_headings[i].unit == AngleUnit::Unstated ? m_unit : m_headings[i].unit;
      return static_cast<bool>(parseAngle(withUnit(row.cells[i].text, unit)));
    };
    int circles = 0;
    for (std::size_t i = 0; i < std::min(row.cells.size(), m_headings.size()); ++i) {
      const auto column = m_headings[i].column;
      const bool isCircle = column == Column::Horizontal || column == Column::Vertical;
      if (isCircle && isAngle(i)) ++circles;
    }
    return circles == 2;
  }

  void readCell(Column column, AngleUnit unit, const CsvCell& cell, RecordedSighting& sighting) {
    if (unit == AngleUnit::Unstated) unit = m_unit;
    const auto entry = [&cell](const std::string& text) { return RecordedEntry{text, cell.column}; };
    switch (column) {
      case Column::Axis:
        sighting.axis = entry(axisOf(cell.text));
        break;
      case Column::Point:
        sighting.point = entry(cell.text);
        break;
      case Column::Round:
        sighting.round = entry(cell.text);
        break;
      case Column::Face:
        sighting.face = entry(faceOf(cell.text));
        break;
      case Column::Horizontal:
        sighting.horizontal = entry(withUnit(cell.text, unit));
        break;
      case Column::Vertical:
        sighting.vertical = entry(withUnit(cell.text, unit));
        break;
      case Column::Slider:
        sighting.slider = entry(withUnit(cell.text, unit));
        break;
      case Column::Note:
        sighting.note = cell.text;
        break;
      case Column::Excluded:
        break;
    }
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
