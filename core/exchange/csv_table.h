#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/recording.h"

namespace alidade {

struct CsvCell {
  std::string text;        ///< unquoted, without blanks around
  std::size_t column = 0;  ///< of its first character, from 1; 0: in a later line than its row's
};

struct CsvRow {
  std::size_t line = 0;  ///< its first, from 1
  bool isRemark = false;
  std::vector<CsvCell> cells;

  std::vector<std::string> texts() const;  ///< of its cells
};

/// Takes a table apart row by row (RFC 4180): cells are parted by tabs, semicolons, | or commas, whichever of
/// these stands in the first row (in this order), or by `separator`, where a blank stands for any number of
/// blanks and tabs, and `wideBlanks` for two and more (table_layout.h); a cell that begins with a double
/// quote ends at the next single one and may hold anything, a quote inside doubled. Quotes elsewhere are the
/// seconds of angles and stay, and so they do in a row of the signs ° ' " alone. Rows without any content are
/// left out; lines that begin with # (and are not a first column of that name) are remarks, taken apart
/// without it. Ends early, with a problem, on a quote left open, but in a remark, and beyond the limits of
/// rows and columns.
class CsvTable {
 public:
  explicit CsvTable(std::string_view text);
  CsvTable(std::string_view text, char separator) : m_text(text), m_separator(separator) {}

  std::optional<CsvRow> next();
  const std::optional<LineProblem>& problem() const { return m_problem; }

 private:
  CsvRow takeRemark();
  bool readRow(CsvRow& row);
  bool readCell(CsvRow& row);
  bool readQuoted(std::string& content);
  bool isFull(const CsvRow& row);
  bool goOn();
  bool isSeparator(char c) const;
  bool areBlanks() const { return m_separator == ' ' || m_separator == '\v'; }
  bool passSeparator();
  void passLineEnd();
  void skipBlanks();
  bool atEnd() const;
  std::size_t column();
  std::string_view restOfLine() const;

  std::string_view m_text;
  char m_separator;
  std::size_t m_at = 0, m_line = 1;
  std::size_t m_counted = 0, m_column = 1;
  std::size_t m_rows = 0;
  bool m_hasSigns = false;   ///< the row is one of signs of angles
  bool m_isHeading = false;  ///< the row stands among the first, is parted by blanks and holds no digit
  std::optional<LineProblem> m_problem;
};

/// The text with the separators of an input method, ； or ，, as ; and ,, where its first row has no others.
std::optional<std::string> withPlainSeparators(std::string_view text);

}  // namespace alidade
