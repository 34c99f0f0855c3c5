#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// What somebody wrote, as a cell that no spreadsheet takes for a formula: a text that begins with = + - @, a
/// tab or a line end gets an apostrophe before it, unless it is a number or an angle.
std::string asPlainCell(std::string_view text);

/// The way back: takes off the apostrophe of `asPlainCell`, and leaves everything else.
std::string fromPlainCell(std::string text);

/// Writes a table (RFC 4180): UTF-8, commas, a first row of names, lines ended by \n. Cells are quoted where
/// `CsvTable` would else read another text.
class CsvText {
 public:
  explicit CsvText(std::initializer_list<std::string_view> names);
  explicit CsvText(const std::vector<std::string_view>& names);

  CsvText& typed(std::string_view text);  ///< what somebody wrote, by `asPlainCell`
  CsvText& word(std::string_view text);   ///< of the program's own
  CsvText& number(double value);          ///< reads back as the same; empty where it is not finite
  CsvText& count(long long value);
  void endRow();

  const std::string& text() const { return m_text; }

 private:
  void add(std::string_view cell);

  std::string m_text;
  bool m_isFirst = true;  ///< of its row
};

}  // namespace alidade
