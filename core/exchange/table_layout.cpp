#include "core/exchange/table_layout.h"

#include <algorithm>
#include <array>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/exchange/words.h"

namespace alidade {

namespace {

/// In the order of `TableColumn::Beside`.
constexpr std::array<std::string_view, 4> besideHeadings{
    "axis position pos axisposition rotation", "turn", "station stn standpoint setup",
    "distance dist slope slopedist slopedistance sd sdist hd hdist hordist"};
constexpr std::size_t distanceAt = static_cast<std::size_t>(TableColumn::Beside::Distance);

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
  if (isOneOf(word, {"rad", "radian", "radians"})) return AngleUnit::Radians;
  if (isOneOf(word, {"dms", "dmmss", "mmss", "ddmmss", "dddmmss"})) return AngleUnit::Dms;
  return std::nullopt;
}

/// Is it one of these words with blanks between them?
bool isAmong(std::string_view words, std::string_view word) {
  return (" " + std::string(words) + " ").find(" " + std::string(word) + " ") != std::string::npos;
}

std::optional<TableColumn> columnNamed(std::string_view word) {
  for (std::size_t i = 0; i < besideHeadings.size(); ++i)
    if (isAmong(besideHeadings[i], word)) return TableColumn{nullptr, static_cast<TableColumn::Beside>(i)};
  for (const RowField& field : rowFields)
    if (isAmong(field.headings, word)) return TableColumn{&field};
  return std::nullopt;
}

/// `slope distance [mm]`, `HD`. A zenith distance is none.
std::optional<ColumnName> distanceName(const std::vector<std::string>& words) {
  ColumnName name;
  for (const std::string& word : words) {
    if (isAmong(besideHeadings[distanceAt], word)) {
      name.column = TableColumn{nullptr, TableColumn::Beside::Distance};
      name.isHorizontal = name.isHorizontal || word.starts_with('h');
    } else if (isOneOf(word, {"horizontal", "hor"})) {
      name.isHorizontal = true;
    } else if (word == "mm") {
      name.metres = 1e-3;
    } else if (!isOneOf(word, {"m", "metre", "metres", "meter", "meters"})) {
      return std::nullopt;
    }
  }
  return name.column ? std::optional(name) : std::nullopt;
}

/// `Cross tilt ["]`, `tilt_length_arcsec`. In other units a tilt is none.
std::optional<ColumnName> tiltName(const std::vector<std::string>& words) {
  bool isTilt = false;
  std::string Reading::*axis = nullptr;
  for (const std::string& word : words) {
    if (isOneOf(word, {"tilt", "incline", "inclination"}))
      isTilt = true;
    else if (isOneOf(word, {"cross", "transverse", "length", "longitudinal"}))
      axis = isOneOf(word, {"cross", "transverse"}) ? &Reading::tiltCrossArcsec : &Reading::tiltLengthArcsec;
    else if (!isOneOf(word, {"arcsec", "arcseconds", "\"", "″"}))
      return std::nullopt;
  }
  if (!isTilt || !axis) return std::nullopt;
  ColumnName name;
  name.column = TableColumn{&rowField(axis)};
  return name;
}

}  // namespace

std::optional<TableColumn> tableColumn(std::string_view key) {
  const auto* const beside = std::find(TableColumn::besideKeys.begin(), TableColumn::besideKeys.end(), key);
  if (beside != TableColumn::besideKeys.end())
    return TableColumn{nullptr, static_cast<TableColumn::Beside>(beside - TableColumn::besideKeys.begin())};
  const RowField* field = rowFieldNamed(key);
  return field ? std::optional(TableColumn{field}) : std::nullopt;
}

ColumnName columnName(const std::string& text) {
  if (const RowField* field = rowFieldNamed(lowerCase(text)); field && isFreeText(*field)) {
    ColumnName own;
    own.column = TableColumn{field};
    return own;
  }
  const std::vector<std::string> words = partsOfName(text);
  if (auto tilt = tiltName(words)) return *std::move(tilt);
  if (auto distance = distanceName(words)) return *std::move(distance);
  ColumnName name;
  bool counts = false, strange = false;
  for (const std::string& word : words) {
    const bool isOfZenith = word == "distance" && name.verticalCircle == "zenith";
    if (isOfZenith) continue;
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
