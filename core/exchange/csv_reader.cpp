#include "core/exchange/csv_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/csv_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// Goes through a table row by row.
class CsvReader {
 public:
  CsvReader(const TableLayout& layout, const std::string& zeroPoint)
      : m_layout(layout), m_zeroPoint(lowerCase(zeroPoint)) {
    if (m_zeroPoint.empty()) m_zeroPoint = "zero";
  }

  Recording read(std::string_view text) {
    m_recording.format = "CSV";
    CsvTable table = m_layout.separator ? CsvTable(text, m_layout.separator) : CsvTable(text);
    std::size_t rows = 0;
    if (m_layout.headRows == 0 && !takeColumns(CsvRow{.line = 1, .isRemark = false, .cells = {}}))
      return std::move(m_recording);
    while (const auto row = table.next()) {
      if (row->isRemark) {
        takeRemark(*row);
      } else if (++rows < m_layout.headRows) {
        continue;
      } else if (rows == m_layout.headRows) {
        if (!takeColumns(*row)) return std::move(m_recording);
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
    if (m_columns.empty()) return std::move(m_recording);
    m_recording.unused = unusedSentences(false);
    m_recording.unusedBySession = unusedSentences(true);
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
    if (m_columns.empty()) {
      if (m_earlyRemarks.size() < mostEarly) m_earlyRemarks.push_back(row);
    } else if (holdsReading(row)) {
      m_remarksWithReading.push_back(row.line);
    }
  }

  void tellOfRemark(std::size_t line) {
    m_recording.unused.push_back(
        Phrase::of("line %1 begins with # and is not used, though it holds a reading", line));
  }

  /// Values of the columns that are told of.
  std::vector<std::string> unusedSentences(bool isBySession) const {
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < m_unusedCells.size(); ++i)
      if (m_unusedCells[i] > 0 && m_columns[i].column.has_value() == isBySession)
        sentences.push_back(
            m_unusedCells[i] == 1
                ? Phrase::of("the column %1 is not used: 1 value", nameOf(i))
                : Phrase::of("the column %1 is not used: %2 values", nameOf(i), m_unusedCells[i]));
    return sentences;
  }

  bool has(TableColumn column) const {
    return std::any_of(m_columns.begin(), m_columns.end(),
                       [column](const ColumnName& name) { return name.column == column; });
  }

  std::string nameOf(std::size_t column) const {
    const bool isNamed = column < m_names.size() && !m_names[column].empty();
    return isNamed ? quotation(m_names[column]) : std::to_string(column + 1);
  }

  /// What the names say, unless the layout says it.
  bool takeColumns(const CsvRow& names) {
    const std::size_t count =
        m_layout.columns.empty() ? names.cells.size() : std::max(m_layout.columns.size(), names.cells.size());
    for (std::size_t i = 0; i < count; ++i) {
      const CsvCell cell = i < names.cells.size() ? names.cells[i] : CsvCell{};
      ColumnName name = columnName(cell.text);
      if (!m_layout.columns.empty())
        name.column = i < m_layout.columns.size() ? tableColumn(m_layout.columns[i]) : std::nullopt;
      if (name.column && !name.column->isOfSession() && has(*name.column)) name.column.reset();
      if (name.column && has(*name.column)) {
        refuse(names.line, cell.column,
               Phrase::of("%1 is a second column for “%2”: rename or remove one of the two",
                          cell.text.empty() ? Phrase::of("column %1", i + 1) : quotation(cell.text),
                          name.column->key()));
        return false;
      }
      const bool isCircle = name.column && name.column->field == &rowField(&Reading::vertical);
      if (isCircle && !name.verticalCircle.empty()) m_recording.verticalCircle = name.verticalCircle;
      m_names.push_back(cell.text);
      m_columns.push_back(std::move(name));
    }
    m_unusedCells.resize(m_columns.size());
    return hasCircles(names.line);
  }

  bool hasCircles(std::size_t line) {
    for (const RowField& field : rowFields) {
      if (!field.remedy || has({&field})) continue;
      refuse(line, 0,
             Phrase::of("no column is named “%1”: begin with a row of names such as "
                        "axis;point;face;horizontal;vertical",
                        field.key));
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
      if (i >= m_columns.size())
        return refuse(
            row.line, cell.column,
            Phrase::of("%1 stands beyond the last named column: name its column, or put double quotes "
                       "around the entry that holds a separator",
                       quotation(cell.text)));
      if (!m_columns[i].column || !m_columns[i].column->isOfSession()) ++m_unusedCells[i];
      if (!m_columns[i].column) continue;
      if (const auto why = readCell(m_columns[i], cell, sighting)) return refuse(row.line, cell.column, *why);
    }
    sighting.isZero = lowerCase(sighting.row.point) == m_zeroPoint;
    m_recording.sightings.push_back(std::move(sighting));
  }

  /// Of a row that was set aside: are both circles read in it?
  bool holdsReading(const CsvRow& row) const {
    const auto isReadable = [&](std::size_t i) {
      return static_cast<bool>(parseAngle(withUnit(row.cells[i].text, unitOf(m_columns[i]))));
    };
    int circles = 0;
    for (std::size_t i = 0; i < std::min(row.cells.size(), m_columns.size()); ++i) {
      const auto column = m_columns[i].column;
      const bool isCircle = column && column->field && column->field->remedy;
      if (isCircle && isReadable(i)) ++circles;
    }
    return circles == 2;
  }

  AngleUnit unitOf(const ColumnName& column) const {
    return column.unit == AngleUnit::Unstated ? m_layout.unit : column.unit;
  }

  /// Why the cell cannot be used.
  std::optional<std::string> readCell(const ColumnName& column, const CsvCell& cell,
                                      RecordedSighting& sighting) {
    const RowField* field = column.column->field;
    if (!column.column->isOfSession()) {
      takeBeside(column, cell, sighting);
    } else if (!field && column.column->beside == TableColumn::Beside::Turn) {
      const Result<int> turn = parseWhole(cell.text);
      if (!turn || *turn < 1)
        return Phrase::of("%1 is no turn: turns of the axis count from 1", quotation(cell.text));
      sighting.time = *turn;
      m_recording.tellsTurns = true;
    } else if (!field) {
      sighting.axis = {axisOf(fromPlainCell(cell.text)), cell.column};
    } else if (field->text) {
      if (isAngle(*field) && cell.text.find(otherSign()) != std::string::npos)
        return Phrase::of("%1 has another decimal sign than the one that was stated: choose either of them",
                          quotation(cell.text));
      sighting.enter(*field, textOf(*field, unitOf(column), fromPlainCell(cell.text)), cell.column);
    } else {
      const auto flag = flagOf(cell.text);
      if (!flag) return Phrase::of("%1 is neither yes nor no: type one of them", quotation(cell.text));
      sighting.row.*field->flag = *flag;
    }
    return std::nullopt;
  }

  /// The station or the distance.
  void takeBeside(const ColumnName& column, const CsvCell& cell, RecordedSighting& sighting) {
    if (column.column->beside == TableColumn::Beside::Station) {
      sighting.station = m_recording.stationNamed(fromPlainCell(cell.text));
      return;
    }
    const Result<double> number = parseNumber(cell.text);
    if (number && *number > 0) {
      sighting.distanceM = *number * column.metres;
      sighting.isDistanceHorizontal = column.isHorizontal;
    } else if (!number || *number < 0) {
      m_recording.distanceProblems.push_back(
          {sighting.line, cell.column,
           Phrase::of("%1 is no distance: type a length in metres, or leave it empty",
                      quotation(cell.text))});
    }
  }

  /// The decimal sign that is not to be; where either may be, none.
  char otherSign() const {
    if (m_layout.decimalSign == DecimalSign::Point) return ',';
    return m_layout.decimalSign == DecimalSign::Comma ? '.' : '\0';
  }

  static std::string textOf(const RowField& field, AngleUnit unit, const std::string& cell) {
    if (isAngle(field)) return withUnit(cell, unit);
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

  const TableLayout& m_layout;
  std::string m_zeroPoint;
  std::vector<std::string> m_names;  ///< in the file
  std::vector<ColumnName> m_columns;
  std::vector<std::size_t> m_unusedCells;
  std::vector<CsvRow> m_earlyRemarks;             ///< before the row of names
  std::vector<std::size_t> m_remarksWithReading;  ///< lines of those after it
  Recording m_recording;
};

}  // namespace

Recording readTable(std::string_view text, const TableLayout& layout, const std::string& zeroPoint) {
  return CsvReader(layout, zeroPoint).read(text);
}

Recording readCsv(std::string_view text, AngleUnit unit, const std::string& zeroPoint) {
  TableLayout layout;
  layout.unit = unit;
  return readTable(text, layout, zeroPoint);
}

}  // namespace alidade
