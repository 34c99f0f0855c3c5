#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

/// User text as a cell that no spreadsheet reads as a formula. A text that begins with = + - @, a tab or a
/// line end gets a leading apostrophe, unless it is a number or an angle.
std::string asPlainCell(std::string_view text);

/// The inverse of `asPlainCell`: removes its apostrophe and keeps everything else.
std::string fromPlainCell(std::string text);

/// Writes a table (RFC 4180): UTF-8, commas, a first row of names, lines ended by \n. Cells are quoted if
/// `CsvTable` would otherwise read a different text.
class CsvText {
 public:
  explicit CsvText(std::initializer_list<std::string_view> names);
  explicit CsvText(const std::vector<std::string_view>& names);

  CsvText& typed(std::string_view text);  ///< user text, protected by `asPlainCell`
  CsvText& word(std::string_view text);   ///< a word of the program
  CsvText& number(double value);          ///< reads back as the same number; empty if not finite
  CsvText& count(long long value);
  void endRow();

  const std::string& text() const { return m_text; }

 private:
  void add(std::string_view cell);

  std::string m_text;
  bool m_isFirst = true;  ///< the next cell is the first in its row
};

}  // namespace alidade
