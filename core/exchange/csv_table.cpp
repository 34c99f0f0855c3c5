#include "core/exchange/csv_table.h"

#include <algorithm>

#include "core/exchange/text_lines.h"

namespace alidade {

namespace {

constexpr std::string_view blanks = " \t";

/// A line that begins with #, unless this is the name of the first column.
bool isComment(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  return line.starts_with('#') && line.size() > 1 &&
         std::string_view(";,\t").find(line[1]) == std::string_view::npos;
}

char separatorOf(std::string_view text) {
  for (const TextLine& line : linesOf(text)) {
    if (line.text.find_first_not_of(blanks) == std::string_view::npos || isComment(line.text)) continue;
    for (const char separator : {'\t', ';'})
      if (line.text.find(separator) != std::string_view::npos) return separator;
    break;
  }
  return ',';
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

/// Goes through the text cell by cell.
class CsvParser {
 public:
  CsvParser(std::string_view text, char separator) : m_text(text), m_separator(separator) {}

  std::variant<CsvTable, LineProblem> parse() {
    while (m_at < m_text.size()) {
      if (isComment(restOfLine())) {
        takeRemark();
        continue;
      }
      CsvRow row{m_line, {}};
      do {
        if (!readCell(row)) return m_problem;
      } while (goOn());
      const bool empty = std::all_of(row.cells.begin(), row.cells.end(),
                                     [](const CsvCell& cell) { return cell.text.empty(); });
      if (!empty) m_table.rows.push_back(std::move(row));
    }
    return std::move(m_table);
  }

 private:
  void takeRemark() {
    const std::string_view line = restOfLine();
    CsvParser inside(line.substr(line.find('#') + 1), m_separator);
    CsvRow row{m_line, {}};
    do {
      if (!inside.readCell(row)) break;
    } while (inside.goOn());
    m_table.remarks.push_back(std::move(row));
    m_at += line.size();
    goOn();
  }

  bool atEnd() const { return m_at == m_text.size() || m_text[m_at] == '\r' || m_text[m_at] == '\n'; }

  /// Counts on from where it was asked last.
  std::size_t column() {
    m_column += characterCount(m_text.substr(m_counted, m_at - m_counted));
    m_counted = m_at;
    return m_column;
  }

  std::string_view restOfLine() const {
    const std::string_view rest = m_text.substr(m_at);
    return rest.substr(0, rest.find_first_of("\r\n"));
  }

  void skipBlanks() {
    while (!atEnd() && m_text[m_at] != m_separator && blanks.find(m_text[m_at]) != std::string_view::npos)
      ++m_at;
  }

  /// Past a separator or the end of the line; true where another cell of this row follows.
  bool goOn() {
    if (m_at == m_text.size()) return false;
    if (m_text[m_at] == m_separator) {
      ++m_at;
      return true;
    }
    passLineEnd();
    return false;
  }

  void passLineEnd() {
    m_at += m_text.substr(m_at, 2) == "\r\n" ? 2 : 1;
    m_counted = m_at;
    m_column = 1;
    ++m_line;
  }

  bool readCell(CsvRow& row) {
    skipBlanks();
    CsvCell cell{{}, column()};
    if (m_at < m_text.size() && m_text[m_at] == '"') {
      const LineProblem open{m_line, cell.column,
                             "the double quote is never closed: close it, or write the cell without it"};
      if (!readQuoted(cell.text)) {
        m_problem = open;
        return false;
      }
    }
    const std::size_t start = m_at;
    while (!atEnd() && m_text[m_at] != m_separator) ++m_at;
    cell.text = trimmed(cell.text + std::string(m_text.substr(start, m_at - start)));
    row.cells.push_back(std::move(cell));
    return true;
  }

  bool readQuoted(std::string& content) {
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

  std::string_view m_text;
  char m_separator;
  std::size_t m_at = 0, m_line = 1;
  std::size_t m_counted = 0, m_column = 1;
  CsvTable m_table;
  LineProblem m_problem;
};

}  // namespace

std::variant<CsvTable, LineProblem> parseCsv(std::string_view text) {
  return CsvParser(text, separatorOf(text)).parse();
}

}  // namespace alidade
