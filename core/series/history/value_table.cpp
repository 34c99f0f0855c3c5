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

namespace alidade {

namespace {

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

bool holdsAny(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](std::string_view part) { return holds(text, part); });
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
  const bool asWritten = holdsAny(last, {".", ","});  // 6.6743(0.0015)
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

/// The content of each column.
struct Columns {
  std::optional<std::size_t> date, value, u;
  double factor = 1;  ///< the column's numbers are this many standard uncertainties
  std::string unit;
};

bool namesDate(const std::string& name) {
  return holdsAny(name, {"date", "year", "epoch", "datum", "jahr", "month", "日期", "年", "时间"}) ||
         isOneOf(name, {"time", "t", "when", "day"});
}

bool namesExpanded(const std::string& name) {
  return holdsAny(name, {"expanded", "erweitert", "扩展"});
}

/// The coverage factor that a heading states as `k=2` or `k = 2.5`.
std::optional<double> factorIn(const std::string& name) {
  std::string plain = name;
  std::erase(plain, ' ');
  const std::size_t at = plain.find("k=");
  if (at == std::string::npos) return std::nullopt;
  const std::size_t end = plain.find_first_not_of("0123456789.,", at + 2);
  const Result<double> factor = parseNumber(plain.substr(at + 2, end - at - 2));
  return factor && *factor > 0 ? std::optional(*factor) : std::nullopt;
}

/// Does the heading begin with the symbol of an expanded uncertainty, as in `U`, `U (mm)`, `U95`?
bool beginsWithU(const std::string& written) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return written.starts_with('U') && (written.size() == 1 || !isLetter(written[1]));
}

bool namesUncertainty(const std::string& name) {
  return namesExpanded(name) || name.starts_with("u9") || (name.starts_with("u") && factorIn(name)) ||
         holdsAny(name,
                  {"uncert", "unsich", "sigma", "error", "standard dev", "std", "不确定度", "σ", "±"}) ||
         isOneOf(name, {"u", "s", "sd", "se", "unc", "err", "unc."}) || name.starts_with("u(") ||
         name.starts_with("u_") || name.starts_with("u [") || name.starts_with("u (") ||
         name.starts_with("s_") || name.starts_with("u/");
}

bool namesValue(const std::string& name) {
  return holdsAny(name, {"value", "wert", "result", "mean", "delta_d", "Δd", "intersection", "值"}) ||
         isOneOf(name, {"x", "y"});
}

std::string unitIn(const std::string& name) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t from = name.find(open), to = name.rfind(close);
    if (from != std::string::npos && to != std::string::npos && to > from)
      return trimmed(std::string_view(name).substr(from + 1, to - from - 1));
  }
  return {};
}

class Reader {
 public:
  explicit Reader(const std::string& text) : m_table(tableOf(text)) {}

  Result<ValueTable> read() {
    while (const std::optional<CsvRow> row = m_table.next()) {
      if (row->isRemark) continue;
      if (m_isFirst && isHead(*row)) {
        readHead(*row);
        continue;
      }
      if (auto problem = readRow(*row)) return *std::move(problem);
      m_isFirst = false;
    }
    if (m_table.problem()) return Problem{m_table.problem()->text()};
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
  Columns m_columns;
  std::vector<std::string> m_names;
  bool m_isFirst = true, m_hasColumns = false;

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
    if (holdsAny(first, {"\t", ";"}) || !holds(first, " ")) return CsvTable(text);
    for (std::size_t at = first.find(','); at != std::string::npos; at = first.find(',', at + 1))
      if (at == 0 || at + 1 == first.size() || !isDigit(first[at - 1]) || !isDigit(first[at + 1]))
        return CsvTable(text);
    return CsvTable(text, ' ');
  }

  static bool isHead(const CsvRow& row) {
    return std::ranges::none_of(
        row.cells, [](const CsvCell& cell) { return parseHistoryDate(cell.text) || parseValue(cell.text); });
  }

  /// Reads a row of column names; of several such rows before the first values, the last one counts.
  void readHead(const CsvRow& row) {
    m_columns = {};
    m_names.clear();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string& written = row.cells[i].text;
      const std::string name = lowerCase(written);
      m_names.push_back(written);
      if (!m_columns.date && namesDate(name)) {
        m_columns.date = i;
      } else if (!m_columns.u && namesUncertainty(name)) {
        m_columns.u = i;
        const bool isExpanded = namesExpanded(name) || (beginsWithU(written) && holdsAny(name, {"9", "%"}));
        m_columns.factor = factorIn(name).value_or(isExpanded ? 2 : 1);
      } else if (!m_columns.value && namesValue(name)) {
        m_columns.value = i;
        m_columns.unit = unitIn(written);
      }
    }
  }

  bool isTaken(std::size_t column) const {
    return m_columns.date == column || m_columns.value == column || m_columns.u == column;
  }

  /// Assigns columns that no name identifies, by the first row of values.
  void assignColumns(const CsvRow& row) {
    m_hasColumns = true;
    const auto firstFree = [&](const auto& fits) -> std::optional<std::size_t> {
      for (std::size_t i = 0; i < row.cells.size(); ++i)
        if (!isTaken(i) && fits(row.cells[i].text)) return i;
      return std::nullopt;
    };
    if (!m_columns.date)
      m_columns.date =
          firstFree([](const std::string& text) { return static_cast<bool>(parseHistoryDate(text)); });
    const auto number = [](const std::string& text) { return parseValue(text).has_value(); };
    if (!m_columns.value) {
      m_columns.value = firstFree(number);
      if (m_columns.value && *m_columns.value < m_names.size())
        m_columns.unit = unitIn(m_names[*m_columns.value]);
    }
    if (!m_columns.u) m_columns.u = firstFree(number);
    m_content.unit = m_columns.unit;
    if (!m_columns.u || *m_columns.u >= m_names.size()) return;
    const std::string& written = m_names[*m_columns.u];
    if (m_columns.factor != 1)
      m_content.remarks.push_back(
          Phrase::of("the column %1 holds expanded uncertainties: each is divided by %2 to give the standard "
                     "uncertainty",
                     quotation(written), displayShortest(m_columns.factor)));
    else if (beginsWithU(written) && !factorIn(lowerCase(written)))
      m_content.remarks.push_back(Phrase::of(
          "the column %1 is read as standard uncertainties (k = 1): halve the values if they are expanded",
          quotation(written)));
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
    if (!m_hasColumns) assignColumns(row);
    if (!m_columns.date)
      return at(row, nullptr,
                Phrase::of("has no date: write year-month-day, year-month, a year or a decimal year"));
    if (!m_columns.value)
      return at(row, nullptr,
                Phrase::of("has no value: each line has a date, a value and its standard uncertainty"));
    const CsvCell *date = cellAt(row, m_columns.date), *value = cellAt(row, m_columns.value),
                  *u = cellAt(row, m_columns.u);
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
      sigma = stated->value / m_columns.factor;
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
