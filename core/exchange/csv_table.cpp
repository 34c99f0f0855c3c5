#include "core/exchange/csv_table.h"

#include <algorithm>
#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/exchange/table_layout.h"
#include "core/exchange/text_lines.h"
#include "core/exchange/words.h"

namespace alidade {

std::vector<std::string> CsvRow::texts() const {
  std::vector<std::string> texts;
  texts.reserve(cells.size());
  for (const CsvCell& cell : cells) texts.push_back(cell.text);
  return texts;
}

namespace {

constexpr std::string_view blanks = " \t";

/// Does the line begin with a # that is not the name of the first column?
bool isComment(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return line.starts_with('#') && line.size() > 1 &&
         std::string_view(";,\t").find(line[1]) == std::string_view::npos;
}

/// The first line that is not a comment; empty if there is none.
std::string_view firstLineOf(std::string_view text) {
  TextLines lines(text);
  while (const auto line = lines.next())
    if (line->text.find_first_not_of(blanks) != std::string_view::npos && !isComment(line->text))
      return line->text;
  return {};
}

char separatorOf(std::string_view text) {
  const std::string_view line = firstLineOf(text);
  for (const char separator : {'\t', ';', '|'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

/// Are all cells of the line empty or signs of degrees, minutes and seconds, one of them a lone double quote?
/// That quote is then a sign and does not open a quoted cell.
bool areAngleSigns(std::string_view line, char separator) {
  bool isAnyQuote = false;
  while (true) {
    const std::size_t end = std::min(line.find(separator), line.size());
    const std::string cell = trimmed(line.substr(0, end));
    if (!isOneOf(cell,
                 {"", "°", "º", "'", "′", "\"", "″", "''", "[°]", "[']", "[\"]", "(°)", "(')", "(\")", "-"}))
      return false;
    isAnyQuote = isAnyQuote || cell == "\"";
    if (end == line.size()) return isAnyQuote;
    line.remove_prefix(end + 1);
  }
}

void replaceAll(std::string& text, std::string_view what, std::string_view with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
}

bool isEmpty(const CsvRow& row) {
  return std::all_of(row.cells.begin(), row.cells.end(),
                     [](const CsvCell& cell) { return cell.text.empty(); });
}

}  // namespace

CsvTable::CsvTable(std::string_view text) : CsvTable(text, separatorOf(text)) {}

std::optional<std::string> withPlainSeparators(std::string_view text) {
  const std::string_view line = firstLineOf(text);
  if (line.find_first_of("\t;|,") != std::string_view::npos) return std::nullopt;
  for (const auto& [wide, plain] : {std::pair("；", ";"), std::pair("，", ",")})
    if (line.find(wide) != std::string_view::npos) {
      std::string changed(text);
      replaceAll(changed, wide, plain);
      return changed;
    }
  return std::nullopt;
}

std::optional<CsvRow> CsvTable::next() {
  while (m_at < m_text.size() && !m_problem) {
    if (isComment(restOfLine())) return takeRemark();
    CsvRow row{.line = m_line, .cells = {}};
    if (!readRow(row)) break;
    if (isEmpty(row)) continue;
    if (++m_rows <= limits::mostRows + 1) return row;  // the first row names the columns
    m_problem = LineProblem{row.line, 0, limits::beyondTheRows()};
  }
  return std::nullopt;
}

bool CsvTable::readRow(CsvRow& row) {
  constexpr std::size_t mostHeadings = 50;
  const bool mayBeHeading = m_rows < mostHeadings;
  m_hasSigns = mayBeHeading && areAngleSigns(restOfLine(), m_separator);
  m_isHeading =
      mayBeHeading && areBlanks() && restOfLine().find_first_of("0123456789") == std::string_view::npos;
  do {
    if (isFull(row) || !readCell(row)) return false;
  } while (goOn());
  return true;
}

bool CsvTable::isFull(const CsvRow& row) {
  if (row.cells.size() < limits::mostColumns) return false;
  m_problem =
      LineProblem{m_line, column(),
                  Phrase::of("has more than %1 columns: a table of readings has about ten; save it again",
                             limits::asCount(limits::mostColumns))};
  return true;
}

CsvRow CsvTable::takeRemark() {
  const std::string_view line = restOfLine();
  CsvTable inside(line.substr(line.find('#') + 1), m_separator);
  inside.m_line = m_line;
  CsvRow row{.line = m_line, .isRemark = true, .cells = {}};
  inside.readRow(row);
  m_at += line.size();
  goOn();
  return row;
}

bool CsvTable::atEnd() const {
  return m_at == m_text.size() || m_text[m_at] == '\r' || m_text[m_at] == '\n';
}

/// The column in characters, counted on from the previous call.
std::size_t CsvTable::column() {
  m_column += characterCount(m_text.substr(m_counted, m_at - m_counted));
  m_counted = m_at;
  return m_column;
}

std::string_view CsvTable::restOfLine() const {
  const std::string_view rest = m_text.substr(m_at);
  return rest.substr(0, rest.find_first_of("\r\n"));
}

void CsvTable::skipBlanks() {
  while (!atEnd() && (m_text[m_at] != m_separator || areBlanks()) &&
         blanks.find(m_text[m_at]) != std::string_view::npos)
    ++m_at;
}

/// Passes a separator or the end of the line; true if another cell of this row follows.
bool CsvTable::goOn() {
  if (m_at < m_text.size() && isSeparator(m_text[m_at])) return passSeparator();
  if (m_at < m_text.size()) passLineEnd();
  return false;
}

/// Does the next character, `c`, separate cells? With `wideBlanks`, a blank separates cells only if a blank
/// or a tab follows. In a heading, a blank before a unit belongs to the cell: Hz [gon].
bool CsvTable::isSeparator(char c) const {
  if (m_isHeading && c == ' ' && m_at + 1 < m_text.size() && isOneOf(m_text.substr(m_at + 1, 1), {"[", "("}))
    return false;
  if (m_separator != wideBlanks) return c == m_separator || (m_separator == ' ' && c == '\t');
  return c == '\t' || (c == ' ' && m_at + 1 < m_text.size() && blanks.find(m_text[m_at + 1]) != blanks.npos);
}

/// Passes a separator; true if a cell follows. Blanks at the end of a line do not begin a cell.
bool CsvTable::passSeparator() {
  if (!areBlanks()) {
    ++m_at;
    return true;
  }
  skipBlanks();
  if (!atEnd()) return true;
  if (m_at < m_text.size()) passLineEnd();
  return false;
}

void CsvTable::passLineEnd() {
  m_at += m_text.substr(m_at, 2) == "\r\n" ? 2 : 1;
  m_counted = m_at;
  m_column = 1;
  ++m_line;
}

bool CsvTable::readCell(CsvRow& row) {
  skipBlanks();
  CsvCell cell{{}, column()};
  const bool isInRowsLine = m_line == row.line;
  if (m_at < m_text.size() && m_text[m_at] == '"' && !m_hasSigns) {
    const LineProblem open{
        m_line, cell.column,
        Phrase::of("the double quote is never closed: close it, or write the cell without it")};
    if (!readQuoted(cell.text)) {
      m_problem = open;
      return false;
    }
  }
  const std::size_t start = m_at;
  while (!atEnd() && !isSeparator(m_text[m_at])) ++m_at;
  cell.text = trimmed(cell.text + std::string(m_text.substr(start, m_at - start)));
  if (!isInRowsLine) cell.column = 0;
  row.cells.push_back(std::move(cell));
  return true;
}

bool CsvTable::readQuoted(std::string& content) {
  for (++m_at; m_at < m_text.size();) {
    const char c = m_text[m_at];
    if (c == '"') {
      ++m_at;
      if (m_at == m_text.size() || m_text[m_at] != '"') return true;
      content += c;
      ++m_at;
    } else if (c == '\r' || c == '\n') {
      content += ' ';
      passLineEnd();
    } else {
      content += c;
      ++m_at;
    }
  }
  return false;
}

}  // namespace alidade
