#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/text_lines.h"

namespace alidade {

struct CsvCell {
  std::string text;        ///< unquoted, without surrounding blanks
  std::size_t column = 0;  ///< column of its first character, from 1; 0 if the cell is in a later
                           ///< line than its row's first cell
};

struct CsvRow {
  std::size_t line = 0;  ///< line of its first cell, from 1
  bool isRemark = false;
  std::vector<CsvCell> cells;

  std::vector<std::string> texts() const;  ///< texts of its cells
};

/// Splits a table into rows of cells (RFC 4180). Cells are separated by tabs, semicolons, | or commas, the
/// first of these found in the first row, or by `separator`: a blank means any number of blanks and tabs,
/// `wideBlanks` two or more (table_layout.h). A cell that begins with a double quote ends at the next quote
/// that is not doubled, and may hold anything. Quotes elsewhere mean arcseconds and stay, as do quotes in a
/// row of only the signs ° ' ". Empty rows are skipped. A line that begins with # is a comment and is split
/// without the #, unless the # names the first column. Reading stops with a problem at an unclosed quote
/// outside a comment, and at the limits of rows and columns. ^Z (0x1A) ends the table, as it ends a DOS file.
class CsvTable {
 public:
  explicit CsvTable(std::string_view text);
  CsvTable(std::string_view text, char separator)
      : m_text(untilEndOfFile(text)), m_separator(separator), m_hasTail(m_text.size() < text.size()) {}

  std::optional<CsvRow> next();
  const std::optional<LineProblem>& problem() const { return m_problem; }
  /// Valid after the last row: the line of the ^Z that ended the table; absent if there was none.
  std::optional<std::size_t> tailLine() const { return m_hasTail ? std::optional(m_line) : std::nullopt; }

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
  bool m_hasTail;  ///< ^Z follows the text
  std::size_t m_at = 0, m_line = 1;
  std::size_t m_counted = 0, m_column = 1;
  std::size_t m_rows = 0;
  bool m_hasSigns = false;   ///< the row holds signs of angles
  bool m_isHeading = false;  ///< one of the first rows, separated by blanks and without a digit
  std::optional<LineProblem> m_problem;
};

/// The text with ； or ， replaced by ; or , if these are the only separators in its first row; else absent.
std::optional<std::string> withPlainSeparators(std::string_view text);

}  // namespace alidade
