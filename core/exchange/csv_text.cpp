#include "core/exchange/csv_text.h"

#include <cmath>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"

namespace alidade {

namespace {

constexpr std::string_view formulaSigns = "=+-@\t\r\n";

/// Would a spreadsheet calculate the text, preceded by any number of apostrophes?
bool looksLikeFormula(std::string_view text) {
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string_view::npos && formulaSigns.find(text[first]) != std::string_view::npos;
}

}  // namespace

std::string asPlainCell(std::string_view text) {
  if (!looksLikeFormula(text)) return std::string(text);
  std::string own(text);
  if (own.front() != '\'' && (parseNumber(own) || parseAngle(own))) return own;
  return "'" + own;
}

std::string fromPlainCell(std::string text) {
  if (text.starts_with('\'') && looksLikeFormula(text)) text.erase(0, 1);
  return text;
}

CsvText::CsvText(std::initializer_list<std::string_view> names)
    : CsvText(std::vector<std::string_view>(names)) {}

CsvText::CsvText(const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) add(name);
  endRow();
}

CsvText& CsvText::typed(std::string_view text) {
  add(asPlainCell(text));
  return *this;
}

CsvText& CsvText::word(std::string_view text) {
  add(text);
  return *this;
}

CsvText& CsvText::number(double value) {
  add(std::isfinite(value) ? shortestText(value) : std::string());
  return *this;
}

CsvText& CsvText::count(long long value) {
  add(std::to_string(value));
  return *this;
}

void CsvText::endRow() {
  m_text += '\n';
  m_isFirst = true;
}

void CsvText::add(std::string_view cell) {
  if (!m_isFirst) m_text += ',';
  const bool isQuoted = cell.find_first_of("\",;\t\r\n") != std::string_view::npos ||
                        (m_isFirst && cell.find('#') != std::string_view::npos);
  m_isFirst = false;
  if (!isQuoted) {
    m_text += cell;
    return;
  }
  m_text += '"';
  for (const char c : cell) {
    if (c == '"') m_text += c;
    m_text += c;
  }
  m_text += '"';
}

}  // namespace alidade
