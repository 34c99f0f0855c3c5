#include "core/exchange/recognise.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/limits.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/exchange/circle_numbers.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/table_beginning.h"
#include "core/exchange/table_columns.h"
#include "core/exchange/table_plan.h"
#include "core/exchange/text_lines.h"

namespace alidade {

namespace {

constexpr std::size_t mostTitleRows = 20;

std::vector<TableCells> rowsOf(std::string_view text, char separator) {
  return beginningOfTable(text, separator, 0).sample;
}

/// The number of cells that may be angles and have decimals or signs.
std::size_t wholeAngles(const std::vector<TableCells>& rows) {
  std::size_t count = 0;
  for (const TableCells& row : rows)
    for (const std::string& cell : row) count += hasDecimals(cell) && mayBeAngle(cell) ? 1 : 0;
  return count;
}

/// The number of cells in more than half of the rows of readings; 0 if no number is that frequent.
std::size_t usualWidth(const std::vector<TableCells>& rows) {
  std::map<std::size_t, std::size_t> counts;
  std::size_t all = 0, most = 0, width = 0;
  for (const TableCells& row : rows) {
    if (std::ranges::count_if(row, mayBeAngle) < 2) continue;
    ++all;
    if (++counts[row.size()] <= most) continue;
    most = counts[row.size()];
    width = row.size();
  }
  return 2 * most > all ? width : 0;
}

/// Do the names of the circles have readings below them?
struct NamesFit {
  bool areNamed = false;  ///< a row names both circles
  bool fits = false;      ///< most rows of readings have angles in these columns
};

NamesFit fitOfNames(const std::vector<TableCells>& rows) {
  for (std::size_t i = 0; i < std::min(rows.size(), mostTitleRows); ++i) {
    if (!nameCircles(rows[i])) continue;
    std::size_t all = 0, good = 0;
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      if (std::ranges::count_if(rows[j], mayBeAngle) < 2) continue;
      ++all;
      const auto isSound = [&](std::size_t k) {
        const auto column = columnName(rows[i][k]).column;
        return !column || !column->isCircle() || (k < rows[j].size() && mayBeAngle(rows[j][k]));
      };
      bool areSound = true;
      for (std::size_t k = 0; k < rows[i].size(); ++k) areSound = areSound && isSound(k);
      good += areSound ? 1 : 0;
    }
    return {.areNamed = true, .fits = all > 0 && 2 * good > all};
  }
  return {};
}

/// Recognises a table by the rows at its beginning.
class TableRecognition {
 public:
  explicit TableRecognition(std::string_view text) : m_text(text) {}

  Recognised recognise() {
    m_found.name = Phrase::of("Table");
    chooseSeparator();
    m_rows = rowsOf(m_text, m_found.table.separator);
    chooseHead();
    chooseColumns();
    findJoinable();
    chooseDecimalSign();
    chooseUnit();
    const auto& columns = m_found.table.columns;
    m_found.saysAxis = std::find(columns.begin(), columns.end(), "axis") != columns.end();
    return std::move(m_found);
  }

 private:
  void reason(const std::string& sentence) { m_found.reasons.push_back(sentence); }

  /// Tabs, semicolons and | always separate cells. Without them, blanks separate cells if blanks fit the rows
  /// better than commas; else commas do.
  void chooseSeparator() {
    const std::string_view line = firstLine();
    for (const char separator : {'\t', ';', '|'})
      if (line.find(separator) != std::string_view::npos || usualWidth(rowsOf(m_text, separator)) > 1) {
        m_found.table.separator = separator;
        return reason(separator == '\t'  ? Phrase::of("tabs separate the columns")
                      : separator == ';' ? Phrase::of("semicolons separate the columns")
                                         : Phrase::of("vertical bars separate the columns"));
      }
    const char blank = blankSeparator();
    m_found.table.separator = blank ? blank : ',';
    reason(blank ? Phrase::of("blanks separate the columns") : Phrase::of("commas separate the columns"));
  }

  /// A blank or `wideBlanks`, whichever fits the names and the readings better; 0 if commas fit best.
  char blankSeparator() const {
    const std::vector<TableCells> byCommas = rowsOf(m_text, ',');
    if (fitOfNames(byCommas).areNamed) return '\0';
    char best = '\0';
    std::size_t most = 0;
    for (const char separator : {' ', wideBlanks}) {
      const std::vector<TableCells> rows = rowsOf(m_text, separator);
      const NamesFit names = fitOfNames(rows);
      const bool fits = names.areNamed ? names.fits : usualWidth(rows) > 1;
      const std::size_t angles = wholeAngles(rows);
      const bool isBetter = angles > wholeAngles(byCommas) || names.areNamed || usualWidth(byCommas) == 0;
      const bool isBest = !best || angles > most || (names.areNamed && angles == most);
      if (!fits || !isBetter || !isBest) continue;
      best = separator;
      most = angles;
    }
    return best;
  }

  std::string_view firstLine() const {
    TextLines lines(m_text);
    while (const auto line = lines.next()) {
      const std::size_t first = line->text.find_first_not_of(" \t");
      if (first != std::string_view::npos && line->text[first] != '#') return line->text;
    }
    return {};
  }

  static bool holdsReading(const TableCells& row) { return std::ranges::count_if(row, mayBeAngle) >= 2; }

  /// The last non-empty row before the readings holds the names; titles may precede it.
  void chooseHead() {
    std::size_t first = 0;
    while (first < std::min(m_rows.size(), mostTitleRows) && !holdsReading(m_rows[first]))
      if (nameCircles(m_rows[first++])) break;
    const bool areBelow =
        first > 0 && first < m_rows.size() && isHeadingAboveNames(m_rows[first - 1], m_rows[first]);
    if (areBelow) ++first;  // the row of circles is above the row of their parts
    if (first == mostTitleRows || first == m_rows.size()) {
      const bool isNamed = !m_rows.empty() && first > 0 && areColumnNames(m_rows[first - 1]);
      if (!isNamed) first = std::min<std::size_t>(1, m_rows.size());
    }
    m_found.table.headRows = first;
    if (first == 0) {
      reason(Phrase::of("no row names the columns"));
    } else {
      reason(first == 1 ? Phrase::of("the first row names the columns")
                        : Phrase::of("row %1 names the columns", first));
    }
  }

  std::size_t width() const {
    std::size_t widest = m_plan.columns.size();
    for (const TableCells& row : m_readings) widest = std::max(widest, row.size());
    return std::min(widest, limits::mostColumns);
  }

  void chooseColumns() {
    const auto end = m_rows.begin() + static_cast<std::ptrdiff_t>(m_found.table.headRows);
    const std::vector<TableCells> head(m_rows.begin(), end), sample(end, m_rows.end());
    TableLayout layout;
    layout.needsVertical = false;
    m_plan = planTable(head, sample, layout);
    m_readings.assign(sample.begin() + static_cast<std::ptrdiff_t>(m_plan.rowsBelow), sample.end());
    if (!head.empty()) m_found.titles = m_plan.names;
    std::vector<std::string>& columns = m_found.table.columns;
    columns.assign(width(), {});
    std::set<std::string> taken;
    for (std::size_t i = 0; i < m_plan.columns.size(); ++i)
      if (const auto& column = m_plan.columns[i].column)
        if (taken.insert(column->key()).second) columns[i] = column->key();
    if (hasCircles(m_found.table) || m_found.table.headRows > 0) return;
    if (guessColumns(m_readings, columns))
      reason(Phrase::of("the columns are guessed from their contents: check them"));
  }

  void findJoinable() {
    for (std::size_t i = 0; i + 1 < m_found.table.columns.size(); ++i)
      if (const std::size_t count = joinableAt(m_readings, i); count > 0) {
        m_found.joinable.push_back({i, 2});
        if (count == 3) m_found.joinable.push_back({i, 3});
      }
    for (const auto& joined : joinedColumns(m_found.table.columns))
      if (std::ranges::find(m_found.joinable, joined) == m_found.joinable.end())
        m_found.joinable.push_back(joined);
    std::ranges::sort(m_found.joinable, {},
                      [](const JoinableColumns& j) { return std::pair(j.first, j.count); });
    if (!joinedColumns(m_found.table.columns).empty())
      reason(Phrase::of("degrees, minutes and any seconds are in separate columns"));
  }

  std::optional<std::size_t> columnOf(std::string_view key) const {
    const auto& columns = m_found.table.columns;
    const auto found = std::find(columns.begin(), columns.end(), key);
    if (found == columns.end()) return std::nullopt;
    return static_cast<std::size_t>(found - columns.begin());
  }

  bool anyCellHas(std::size_t column, char sign) const {
    return std::ranges::any_of(m_readings, [&](const TableCells& row) {
      return column < row.size() && row[column].find(sign) != std::string::npos;
    });
  }

  void chooseDecimalSign() {
    bool hasPoint = false, hasComma = false;
    for (std::size_t i = 0; i < m_found.table.columns.size(); ++i) {
      const auto column = tableColumn(m_found.table.columns[i]);
      if (!column || !column->field || !isAngle(*column->field)) continue;
      hasPoint = hasPoint || anyCellHas(i, '.');
      hasComma = hasComma || anyCellHas(i, ',');
    }
    if (hasPoint == hasComma) return;
    m_found.table.decimalSign = hasComma ? DecimalSign::Comma : DecimalSign::Point;
    reason(hasComma ? Phrase::of("the decimal sign is a comma") : Phrase::of("the decimal sign is a point"));
  }

  /// The plain numbers of the circle `key`; empty if its heading has a unit.
  std::vector<double> plainOf(std::string_view key) const {
    std::vector<double> numbers;
    const auto column = columnOf(key);
    if (!column || columnOf(std::string(key) + "_minutes")) return numbers;
    for (const PlannedAngle& angle : m_plan.angles)
      if (angle.at[0] == *column && angle.unit != AngleUnit::Unstated) return numbers;
    for (const TableCells& row : m_readings) {
      if (*column >= row.size()) continue;
      if (const auto number = parseNumber(row[*column]); number && !parseAngle(row[*column]))
        numbers.push_back(*number);
    }
    return numbers;
  }

  /// Proposes the unit. Only readings in gon exceed 360. Only decimal degrees and gon have more than 59
  /// in the first two decimals, which hold minutes in degrees.minutes-seconds.
  void chooseUnit() {
    const std::vector<double> horizontal = plainOf("horizontal"), vertical = plainOf("vertical");
    std::vector<double> all = horizontal;
    all.insert(all.end(), vertical.begin(), vertical.end());
    if (all.empty()) return;
    m_found.asksUnit = true;
    const double largest = *std::max_element(all.begin(), all.end());
    constexpr double turn = 360;
    const AngleUnit unit = unitByNumbers(all, vertical);
    const bool mayBeDms = std::all_of(all.begin(), all.end(), isSexagesimal);
    if (unit == AngleUnit::Unstated || (unit == AngleUnit::Degrees && mayBeDms)) return;
    m_found.table.unit = unit;
    if (largest > turn)
      reason(Phrase::of("gon, because %1 is more than 360", fixedText(largest, 4)));
    else if (unit == AngleUnit::Gon)
      reason(Phrase::of("gon, because the vertical readings are near 100 or 300: check the unit"));
    else
      reason(
          Phrase::of("decimal degrees, because the vertical readings are near 90 or 270 and have more than "
                     "59 in the place of minutes: check the unit"));
  }

  static bool isSexagesimal(double number) {
    const double minutes = (std::abs(number) - std::floor(std::abs(number))) * 100;
    constexpr double rounding = 1e-6;
    const double whole = std::floor(minutes + rounding), seconds = (minutes - whole) * 100;
    return whole < 60 && seconds < 60 - rounding;
  }

  std::string_view m_text;
  std::vector<TableCells> m_rows, m_readings;
  TablePlan m_plan;
  Recognised m_found;
};

}  // namespace

Recognised recogniseTable(std::string_view beginning) {
  const auto plain = withPlainSeparators(beginning);
  return TableRecognition(plain ? std::string_view(*plain) : beginning).recognise();
}

}  // namespace alidade
