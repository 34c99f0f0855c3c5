#include "core/exchange/table_layout.h"

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

constexpr std::string_view axisHeadings = "axis position pos axisposition rotation", turnHeadings = "turn";

/// The words of a column's name: letters and signs other than separators, in small letters.
std::vector<std::string> partsOfName(const std::string& name) {
  std::vector<std::string> words;
  bool inWord = false;
  for (const char c : lowerCase(name)) {
    const bool parts = std::string_view(" _-./:[](){}").find(c) != std::string_view::npos;
    if (!parts && !inWord) words.emplace_back();
    if (!parts) words.back() += c;
    inWord = !parts;
  }
  return words;
}

std::optional<AngleUnit> unitNamed(std::string_view word) {
  if (isOneOf(word, {"gon", "grad", "gons", "g"})) return AngleUnit::Gon;
  if (isOneOf(word, {"deg", "degree", "degrees", "°", "dd"})) return AngleUnit::Degrees;
  if (isOneOf(word, {"dms", "dmmss", "mmss", "ddmmss", "dddmmss"})) return AngleUnit::Dms;
  return std::nullopt;
}

/// Is it one of these words with blanks between them?
bool isAmong(std::string_view words, std::string_view word) {
  return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

std::optional<TableColumn> columnNamed(std::string_view word) {
  if (isAmong(axisHeadings, word)) return TableColumn{nullptr};
  if (isAmong(turnHeadings, word)) return TableColumn{nullptr, true};
  for (const RowField& field : rowFields)
    if (isAmong(field.headings, word)) return TableColumn{&field};
  return std::nullopt;
}

}  // namespace

std::optional<TableColumn> tableColumn(std::string_view key) {
  if (key == "axis") return TableColumn{nullptr};
  if (key == "turn") return TableColumn{nullptr, true};
  const RowField* field = rowFieldNamed(key);
  return field ? std::optional(TableColumn{field}) : std::nullopt;
}

ColumnName columnName(const std::string& text) {
  ColumnName name;
  bool counts = false, strange = false;
  for (const std::string& word : partsOfName(text)) {
    if (const auto column = columnNamed(word); column && !name.column) {
      name.column = column;
      if (word == "elevation") name.verticalCircle = "elevation";
      if (word == "zenith" || word == "zenithdistance") name.verticalCircle = "zenith";
    } else if (const auto unit = unitNamed(word)) {
      name.unit = *unit;
    } else if (isOneOf(word, {"no", "nr", "number", "id", "name"})) {
      counts = true;
    } else if (!column && !isOneOf(word, {"angle", "circle", "reading", "readings", "of", "the", "typed"})) {
      strange = true;
    }
  }
  if (!name.column && counts) name.column = TableColumn{&rowField(&Reading::point)};
  if (strange) name.column.reset();
  return name;
}

bool areColumnNames(const std::vector<std::string>& cells) {
  bool isAnyKnown = false;
  for (const std::string& cell : cells) {
    if (parseNumber(cell) || parseAngle(cell)) return false;
    isAnyKnown = isAnyKnown || columnName(cell).column.has_value();
  }
  return isAnyKnown;
}

}  // namespace alidade
