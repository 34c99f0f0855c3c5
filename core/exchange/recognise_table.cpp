#include "core/exchange/recognise_table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/text_lines.h"

namespace alidade {

namespace {

constexpr std::size_t mostRowsLookedAt = 200, mostTitleRows = 20;

using Cells = std::vector<std::string>;

std::vector<Cells> rowsOf(std::string_view text, char separator) {
  CsvTable table = separator ? CsvTable(text, separator) : CsvTable(text);
  std::vector<Cells> rows;
  while (const auto row = table.next()) {
    if (row->isRemark) continue;
    Cells cells;
    for (const CsvCell& cell : row->cells) cells.push_back(cell.text);
    rows.push_back(std::move(cells));
    if (rows.size() == mostRowsLookedAt) break;
  }
  return rows;
}

bool isNumberCell(const std::string& cell) {
  return static_cast<bool>(parseNumber(cell));
}

/// Could it be a reading of a circle, once its unit is known?
bool mayBeAngle(const std::string& cell) {
  constexpr double beyond = 400;
  if (const auto number = parseNumber(cell)) return std::abs(*number) < beyond;
  return static_cast<bool>(parseAngle(cell));
}

bool hasDecimals(const std::string& cell) {
  return cell.find_first_of(".,") != std::string::npos || (!isNumberCell(cell) && parseAngle(cell));
}

/// Recognises a table in the rows at its beginning.
class TableRecognition {
 public:
  explicit TableRecognition(std::string_view text) : m_text(text) {}

  Recognised recognise() {
    m_found.name = "Table";
    chooseSeparator();
    m_rows = rowsOf(m_text, m_found.table.separator);
    chooseHead();
    chooseColumns();
    chooseDecimalSign();
    chooseUnit();
    const auto& columns = m_found.table.columns;
    m_found.saysAxis = std::find(columns.begin(), columns.end(), "axis") != columns.end();
    return std::move(m_found);
  }

 private:
  void reason(const std::string& sentence) { m_found.reasons.push_back(sentence); }

  /// Tabs and semicolons part cells wherever they stand; commas and blanks only where every row has as many.
  void chooseSeparator() {
    const auto evenColumns = [&](char separator) -> std::size_t {
      const std::vector<Cells> rows = rowsOf(m_text, separator);
      std::set<std::size_t> counts;
      for (std::size_t i = rows.size() / 2; i < rows.size(); ++i) counts.insert(rows[i].size());
      return counts.size() == 1 ? *counts.begin() : 0;
    };
    const std::string_view line = firstLine();
    for (const char separator : {'\t', ';'})
      if (line.find(separator) != std::string_view::npos || evenColumns(separator) > 1) {
        m_found.table.separator = separator;
        return reason(separator == '\t' ? Phrase::of("tabs part the columns")
                                        : Phrase::of("semicolons part the columns"));
      }
    const bool isNamed = areColumnNames(firstRow(','));
    const std::size_t byBlanks = evenColumns(' ');
    const bool areBlanks = !isNamed && byBlanks > 1 && wholeAngles(' ') > wholeAngles(',');
    m_found.table.separator = areBlanks ? ' ' : ',';
    reason(areBlanks ? Phrase::of("blanks part the columns") : Phrase::of("commas part the columns"));
  }

  std::string_view firstLine() const {
    TextLines lines(m_text);
    while (const auto line = lines.next()) {
      const std::size_t first = line->text.find_first_not_of(" \t");
      if (first != std::string_view::npos && line->text[first] != '#') return line->text;
    }
    return {};
  }

  Cells firstRow(char separator) const {
    const std::vector<Cells> rows = rowsOf(m_text, separator);
    return rows.empty() ? Cells() : rows.front();
  }

  /// Cells that are angles with decimals or signs, so cut.
  std::size_t wholeAngles(char separator) const {
    std::size_t count = 0;
    for (const Cells& row : rowsOf(m_text, separator))
      for (const std::string& cell : row) count += hasDecimals(cell) && mayBeAngle(cell) ? 1 : 0;
    return count;
  }

  static bool holdsReading(const Cells& row) {
    return std::count_if(row.begin(), row.end(), mayBeAngle) >= 2;
  }

  /// The names stand in the last row that has some before the readings; above them there may be a title.
  void chooseHead() {
    std::size_t first = 0;
    while (first < std::min(m_rows.size(), mostTitleRows) && !holdsReading(m_rows[first])) {
      if (namesCircles(m_rows[first])) {
        ++first;
        break;
      }
      ++first;
    }
    if (first == mostTitleRows || first == m_rows.size()) {
      const bool isNamed = !m_rows.empty() && first > 0 && areColumnNames(m_rows[first - 1]);
      if (!isNamed) first = std::min<std::size_t>(1, m_rows.size());
    }
    m_found.table.headRows = first;
    if (first > 0 && !m_rows.empty()) m_found.titles = m_rows[first - 1];
    if (first == 0) {
      reason(Phrase::of("no row names the columns"));
    } else {
      reason(first == 1 ? Phrase::of("the first row names the columns")
                        : Phrase::of("row %1 names the columns", first));
    }
  }

  static bool namesCircles(const Cells& row) {
    int circles = 0;
    for (const std::string& cell : row) {
      const auto column = columnName(cell).column;
      circles += column && column->field && column->field->remedy ? 1 : 0;
    }
    return circles >= 2;
  }

  std::size_t width() const {
    std::size_t widest = m_found.titles.size();
    for (const Cells& row : m_rows) widest = std::max(widest, row.size());
    return std::min(widest, limits::mostColumns);
  }

  void chooseColumns() {
    std::vector<std::string>& columns = m_found.table.columns;
    columns.assign(width(), {});
    std::set<std::string> taken;
    for (std::size_t i = 0; i < m_found.titles.size(); ++i)
      if (const auto column = columnName(m_found.titles[i]).column)
        if (taken.insert(std::string(column->key())).second) columns[i] = std::string(column->key());
    if (!hasCircles(m_found.table) && m_found.table.headRows == 0) guessColumns();
  }

  /// Without names: the last two columns that hold angles with decimals are the circles, horizontal first; a
  /// column of 0 and 180 before them is the axis, one of 1 and 2 the face, another of whole numbers the
  /// point.
  void guessColumns() {
    std::vector<std::string>& columns = m_found.table.columns;
    std::vector<std::size_t> angles;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (share(i, [](const std::string& cell) { return hasDecimals(cell) && mayBeAngle(cell); }) > 0.5)
        angles.push_back(i);
    if (angles.size() < 2) return;
    columns[angles[0]] = "horizontal";
    columns[angles[1]] = "vertical";
    if (angles.size() > 2) columns[angles[2]] = "slider";
    for (std::size_t i = 0; i < angles[0]; ++i) {
      const std::set<std::string> values = valuesOf(i);
      const auto areOf = [&values](const std::set<std::string>& allowed) {
        return !values.empty() && std::includes(allowed.begin(), allowed.end(), values.begin(), values.end());
      };
      const auto isFree = [&columns](const char* key) {
        return std::find(columns.begin(), columns.end(), key) == columns.end();
      };
      if (areOf({"0", "180"}) && isFree("axis") && values.contains("180")) {
        columns[i] = "axis";
      } else if (areOf({"1", "2"}) && i > 0 && isFree("face")) {
        columns[i] = "face";
      } else if (isFree("point")) {
        columns[i] = "point";
      }
    }
    reason(Phrase::of("the columns are guessed from what stands in them: check them"));
  }

  template <typename Is>
  double share(std::size_t column, Is is) const {
    std::size_t count = 0, all = 0;
    for (std::size_t i = m_found.table.headRows; i < m_rows.size(); ++i) {
      if (column >= m_rows[i].size() || m_rows[i][column].empty()) continue;
      ++all;
      count += is(m_rows[i][column]) ? 1 : 0;
    }
    return all == 0 ? 0 : static_cast<double>(count) / static_cast<double>(all);
  }

  std::set<std::string> valuesOf(std::size_t column) const {
    std::set<std::string> values;
    for (std::size_t i = m_found.table.headRows; i < m_rows.size(); ++i)
      if (column < m_rows[i].size()) values.insert(m_rows[i][column]);
    return values;
  }

  std::optional<std::size_t> columnOf(std::string_view key) const {
    const auto& columns = m_found.table.columns;
    const auto found = std::find(columns.begin(), columns.end(), key);
    if (found == columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
  }

  void chooseDecimalSign() {
    bool hasPoint = false, hasComma = false;
    for (const char* key : {"horizontal", "vertical", "slider"})
      if (const auto column = columnOf(key)) {
        hasPoint =
            hasPoint || share(*column, [](const auto& cell) { return cell.find('.') != cell.npos; }) > 0;
        hasComma =
            hasComma || share(*column, [](const auto& cell) { return cell.find(',') != cell.npos; }) > 0;
      }
    if (hasPoint == hasComma) return;
    m_found.table.decimalSign = hasComma ? DecimalSign::Comma : DecimalSign::Point;
    reason(hasComma ? Phrase::of("decimals stand behind a comma")
                    : Phrase::of("decimals stand behind a point"));
  }

  /// The plain numbers of a circle whose name tells no unit.
  std::vector<double> plainOf(std::string_view key) const {
    std::vector<double> numbers;
    const auto column = columnOf(key);
    if (!column) return numbers;
    const bool isNamed =
        *column < m_found.titles.size() && columnName(m_found.titles[*column]).unit != AngleUnit::Unstated;
    if (isNamed) return numbers;
    for (std::size_t i = m_found.table.headRows; i < m_rows.size(); ++i) {
      if (*column >= m_rows[i].size()) continue;
      const std::string& cell = m_rows[i][*column];
      if (const auto number = parseNumber(cell); number && !parseAngle(cell)) numbers.push_back(*number);
    }
    return numbers;
  }

  /// Only gon go beyond 360 on a circle, and only decimal degrees and gon have decimals beyond 59 where
  /// minutes stand.
  void chooseUnit() {
    const std::vector<double> horizontal = plainOf("horizontal"), vertical = plainOf("vertical");
    std::vector<double> all = horizontal;
    all.insert(all.end(), vertical.begin(), vertical.end());
    if (all.empty()) return;
    m_found.asksUnit = true;
    const auto largest = std::max_element(all.begin(), all.end());
    if (*largest >= 360) {
      m_found.table.unit = AngleUnit::Gon;
      return reason(Phrase::of("gon, as %1 is more than 360", fixedText(*largest, 4)));
    }
    const bool mayBeDms = std::all_of(all.begin(), all.end(), isSexagesimal);
    const double fromGon = spreadAround(vertical, 100), fromDegrees = spreadAround(vertical, 90);
    if (!vertical.empty() && fromGon < fromDegrees / 2) {
      m_found.table.unit = AngleUnit::Gon;
      return reason(Phrase::of("gon, as the vertical readings lie around 100 or 300: check it"));
    }
    if (!vertical.empty() && fromDegrees < fromGon / 2 && !mayBeDms) {
      m_found.table.unit = AngleUnit::Degrees;
      return reason(Phrase::of(
          "decimal degrees, as the vertical readings lie around 90 or 270 and hold more than 59 where "
          "minutes would stand: check it"));
    }
  }

  static bool isSexagesimal(double number) {
    const double minutes = (std::abs(number) - std::floor(std::abs(number))) * 100;
    constexpr double rounding = 1e-6;
    const double whole = std::floor(minutes + rounding), seconds = (minutes - whole) * 100;
    return whole < 60 && seconds < 60 - rounding;
  }

  /// How far the mean distance of the readings from the horizon is, were it there in either face.
  static double spreadAround(const std::vector<double>& vertical, double horizon) {
    double sum = 0;
    for (const double number : vertical)
      sum += std::min(std::abs(number - horizon), std::abs(number - 3 * horizon));
    return vertical.empty() ? 0 : sum / static_cast<double>(vertical.size());
  }

  std::string_view m_text;
  std::vector<Cells> m_rows;
  Recognised m_found;
};

}  // namespace

Recognised recogniseTable(std::string_view beginning) {
  return TableRecognition(beginning).recognise();
}

}  // namespace alidade
