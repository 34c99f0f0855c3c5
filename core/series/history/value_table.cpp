#include "core/series/history/value_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/typed_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"
#include "core/series/history/history_date.h"
#include "core/series/history/value_columns.h"

namespace alidade {

namespace {

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// A value, with its uncertainty if that is in the same cell.
struct ReadValue {
  double value = 0;
  std::optional<double> u = {};
};

/// `6.6743(15)` or `6.6743(15)e-11`: the digits in parentheses refer to the last decimals.
std::optional<ReadValue> withParentheses(const std::string& text) {
  const std::size_t open = text.find('('), close = text.find(')');
  if (open == std::string::npos || close == std::string::npos || close < open) return std::nullopt;
  const std::string digits = text.substr(0, open), last = text.substr(open + 1, close - open - 1);
  const Result<double> value = parseNumber(digits + text.substr(close + 1)), number = parseNumber(digits);
  const Result<double> places = parseNumber(last);
  if (!value || !number || !places) return std::nullopt;
  const std::size_t point = digits.find_first_of(".,");
  const std::size_t decimals = point == std::string::npos ? 0 : digits.size() - point - 1;
  const bool asWritten = last.find_first_of(".,") != std::string::npos;  // 6.6743(0.0015)
  const double unit = asWritten ? 1 : std::pow(10.0, -static_cast<double>(decimals));
  const Result<double> power = parseNumber("1" + text.substr(close + 1));
  return ReadValue{*value, std::abs(*places) * unit * (power ? *power : 1)};
}

std::optional<ReadValue> parseValue(const std::string& typed) {
  const std::string text = plainSigns(typed);
  for (const std::string_view sign : {"±", "+/-", "+-"})
    if (const std::size_t at = text.find(sign); at != std::string::npos) {
      const Result<double> value = parseNumber(text.substr(0, at)),
                           u = parseNumber(text.substr(at + sign.size()));
      if (value && u) return ReadValue{*value, *u};
      return std::nullopt;
    }
  if (auto read = withParentheses(text)) return read;
  const Result<double> value = parseNumber(text);
  if (!value) return std::nullopt;
  return ReadValue{*value};
}

bool isBlank(std::string_view text) {
  return isOneOf(lowerCase(trimmed(text)), {"", "-", "–", "—", "n/a", "na", "nan", "none", "null"});
}

class Reader {
 public:
  explicit Reader(const std::string& text) : m_table(tableOf(text)) {}

  Result<ValueTable> read() {
    std::vector<CsvRow> rows;
    while (const std::optional<CsvRow> row = m_table.next()) {
      if (row->isRemark) continue;
      if (rows.empty() && isHead(*row)) {
        m_names = row->texts();  // of several such rows, the last one counts
        continue;
      }
      notice(*row);
      rows.push_back(*row);
    }
    if (m_table.problem()) return Problem{m_table.problem()->text()};
    for (const CsvRow& row : rows)
      if (auto problem = readRow(row)) return *std::move(problem);
    if (m_content.values.empty())
      return Problem{
          Phrase::of("holds no value: each line has a date, a value and its standard uncertainty")};
    unifyYears();
    return std::move(m_content);
  }

 private:
  CsvTable m_table;
  ValueTable m_content;
  std::vector<HistoryDate> m_dates;
  std::vector<std::string> m_names;
  std::vector<std::optional<ColumnContent>> m_contents;  ///< absent: only blank cells so far
  std::optional<ValueColumns> m_columns;

  /// Blanks separate the columns if nothing else does, even if numbers contain commas.
  static CsvTable tableOf(const std::string& text) {
    CsvTable usual(text);
    std::optional<CsvRow> row = usual.next();
    while (row && row->isRemark) row = usual.next();
    if (!row) return CsvTable(text);
    TextLines lines(text);
    std::optional<TextLine> line = lines.next();
    while (line && line->number < row->line) line = lines.next();
    const std::string first = line ? trimmed(line->text) : "";
    if (first.find_first_of("\t;") != std::string::npos || !holds(first, " ")) return CsvTable(text);
    for (std::size_t at = first.find(','); at != std::string::npos; at = first.find(',', at + 1))
      if (at == 0 || at + 1 == first.size() || !isDigit(first[at - 1]) || !isDigit(first[at + 1]))
        return CsvTable(text);
    return CsvTable(text, ' ');
  }

  static bool isHead(const CsvRow& row) {
    return std::ranges::none_of(
        row.cells, [](const CsvCell& cell) { return parseHistoryDate(cell.text) || parseValue(cell.text); });
  }

  /// Notes what each column holds.
  void notice(const CsvRow& row) {
    m_contents.resize(std::max(m_contents.size(), row.cells.size()));
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& text = row.cells[i].text;
      if (m_contents[i] || isBlank(text)) continue;
      const std::optional<ReadValue> number = parseValue(text);
      m_contents[i] = {.isDate = static_cast<bool>(parseHistoryDate(text)),
                       .isNumber = number.has_value(),
                       .hasUncertainty = number && number->u};
    }
  }

  std::optional<Problem> assignColumns() {
    std::vector<ColumnContent> contents;
    for (const auto& content : m_contents) contents.push_back(content.value_or(ColumnContent()));
    const Result<ValueColumns> columns = valueColumns(m_names, contents);
    if (!columns) return columns.problem();
    m_columns = *columns;
    m_content.unit = columns->unit;
    if (!columns->remark.empty()) m_content.remarks.push_back(columns->remark);
    return std::nullopt;
  }

  static Problem at(const CsvRow& row, const CsvCell* cell, std::string what) {
    return Problem{LineProblem{row.line, cell ? cell->column : 0, std::move(what)}.text()};
  }

  const CsvCell* cellAt(const CsvRow& row, std::optional<std::size_t> column) const {
    return column && *column < row.cells.size() ? &row.cells[*column] : nullptr;
  }

  std::optional<Problem> readRow(const CsvRow& row) {
    if (hasCommasInNumbers(row))
      return at(row, nullptr,
                Phrase::of("has commas between and within its numbers: separate the numbers by semicolons"));
    if (!m_columns)
      if (auto problem = assignColumns()) return problem;
    if (!m_columns->date)
      return at(row, nullptr,
                Phrase::of("has no date: write year-month-day, year-month, a year or a decimal year"));
    if (!m_columns->value)
      return at(row, nullptr,
                Phrase::of("has no value: each line has a date, a value and its standard uncertainty"));
    const CsvCell *date = cellAt(row, m_columns->date), *value = cellAt(row, m_columns->value),
                  *u = cellAt(row, m_columns->u);
    if (!value || isBlank(value->text)) {
      m_content.remarks.push_back(Phrase::of("line %1 has no value and is skipped", row.line));
      return std::nullopt;
    }
    const Result<HistoryDate> day = parseHistoryDate(date ? date->text : "");
    if (!day) return at(row, date, day.problem().what);
    const std::optional<ReadValue> read = parseValue(value->text);
    if (!read) return at(row, value, Phrase::of("%1 is no number", quotation(value->text)));
    std::optional<double> sigma = read->u;
    if (!sigma && u && !isBlank(u->text)) {
      const std::optional<ReadValue> stated = parseValue(u->text);
      if (!stated) return at(row, u, Phrase::of("%1 is no number", quotation(u->text)));
      sigma = stated->value / m_columns->factor;
    }
    if (!sigma)
      return at(row, u,
                Phrase::of("has no standard uncertainty, so the value cannot be weighted: enter the "
                           "uncertainty in the third column"));
    if (!(*sigma > 0))
      return at(row, u,
                Phrase::of("the standard uncertainty %1 is not greater than 0: the value cannot be weighted",
                           displayedU(*sigma)));
    constexpr double largest = 1e30, smallest = 1e-30;  // keeps squares of weighted values finite
    const auto outOfRange = [&](const CsvCell* cell, double number) {
      return at(row, cell,
                Phrase::of("%1 is out of range: values reach up to 1e30, uncertainties from 1e-30 to 1e30",
                           shortestText(number)));
    };
    if (!(std::abs(read->value) <= largest)) return outOfRange(value, read->value);
    if (*sigma < smallest || *sigma > largest) return outOfRange(u, *sigma);
    m_dates.push_back(*day);
    m_content.values.push_back({day->text, day->day, read->value, *sigma, *sigma, {}, 0, 0});
    return std::nullopt;
  }

  static std::string displayedU(double sigma) { return shortestText(sigma); }

  /// True for a row like 2001,3,25,0,12, in which commas are both separators and decimal signs.
  bool hasCommasInNumbers(const CsvRow& row) const {
    constexpr std::size_t pieces = 5;
    return row.cells.size() == pieces && (m_names.empty() || m_names.size() < pieces) &&
           std::all_of(row.cells.begin() + 1, row.cells.end(),
                       [](const CsvCell& cell) { return static_cast<bool>(parseWhole(cell.text)); });
  }

  void unifyYears() {
    using Form = HistoryDate::Form;
    const auto isDecimal = [](const HistoryDate& date) { return date.form == Form::DecimalYear; };
    if (std::ranges::none_of(m_dates, isDecimal)) return;
    for (std::size_t i = 0; i < m_dates.size(); ++i)
      if (m_dates[i].form == Form::Year) m_content.values[i].day = asDecimalYear(m_dates[i]).day;
  }
};

}  // namespace

Result<ValueTable> readValueTable(std::string_view bytes) {
  const Result<std::string> text = utf8Text(bytes);
  if (!text) return text.problem();
  return Reader(*text).read();
}

}  // namespace alidade
