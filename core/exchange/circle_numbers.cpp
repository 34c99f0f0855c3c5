#include "core/exchange/circle_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"
#include "core/base/typed_text.h"

namespace alidade {

namespace {

/// Removes the mark of a part of an angle: 41' becomes 41.
std::string withoutMark(const std::string& cell) {
  std::string text = plainSigns(cell);
  while (text.ends_with('\'') || text.ends_with('"')) text.pop_back();
  constexpr std::string_view degree = "°";
  if (text.ends_with(degree)) text.resize(text.size() - degree.size());
  return text;
}

bool holdsDegreeSign(const std::vector<TableCells>& rows, std::size_t column) {
  return std::ranges::any_of(rows, [column](const TableCells& row) {
    return column < row.size() && plainSigns(row[column]).find("°") != std::string::npos;
  });
}

}  // namespace

bool ColumnNumbers::areWithin(double low, double high) const {
  return areAll && std::ranges::all_of(values, [&](double value) { return value >= low && value <= high; });
}

bool ColumnNumbers::areAtMost(double high) const {
  return std::ranges::all_of(values, [&](double value) { return value <= high; });
}

bool ColumnNumbers::areMostlyWhole() const {
  const auto whole = std::ranges::count_if(values, [](double value) { return value == std::floor(value); });
  return whole > 0 && 2 * static_cast<std::size_t>(whole) >= cells;
}

bool ColumnNumbers::areMostlyWithin(double low, double high) const {
  const auto within =
      std::ranges::count_if(values, [&](double value) { return value >= low && value <= high; });
  return within > 0 && 2 * static_cast<std::size_t>(within) >= cells;
}

ColumnNumbers numbersIn(const std::vector<TableCells>& rows, std::size_t column) {
  ColumnNumbers numbers{.areAll = true, .areWhole = true};
  for (const TableCells& row : rows) {
    if (column >= row.size() || row[column].empty()) continue;
    ++numbers.cells;
    const auto number = parseNumber(withoutMark(row[column]));
    numbers.areAll = numbers.areAll && static_cast<bool>(number);
    if (!number) continue;
    numbers.values.push_back(*number);
    numbers.areWhole = numbers.areWhole && *number == std::floor(*number);
  }
  numbers.areAll = numbers.areAll && !numbers.values.empty();
  return numbers;
}

double spreadAround(const std::vector<double>& vertical, double horizon) {
  double sum = 0;
  for (const double number : vertical)
    sum += std::min(std::abs(number - horizon), std::abs(number - 3 * horizon));
  return vertical.empty() ? 0 : sum / static_cast<double>(vertical.size());
}

AngleUnit unitByNumbers(const std::vector<double>& all, const std::vector<double>& vertical) {
  constexpr double turn = 360;
  if (std::ranges::any_of(all, [](double number) { return number > turn; })) return AngleUnit::Gon;
  if (vertical.empty()) return AngleUnit::Unstated;
  const double fromGon = spreadAround(vertical, 100), fromDegrees = spreadAround(vertical, 90);
  if (fromGon < fromDegrees / 2) return AngleUnit::Gon;
  return fromDegrees < fromGon / 2 ? AngleUnit::Degrees : AngleUnit::Unstated;
}

std::size_t joinableAt(const std::vector<TableCells>& rows, std::size_t column) {
  constexpr double turn = 360, minutesInDegree = 60;
  const ColumnNumbers degrees = numbersIn(rows, column), minutes = numbersIn(rows, column + 1);
  const bool areDegrees = degrees.areWhole && degrees.areWithin(-turn, turn);
  if (!areDegrees || holdsDegreeSign(rows, column + 1) ||
      !minutes.areWithin(-minutesInDegree, minutesInDegree))
    return 0;
  if (!minutes.areWhole) return 2;
  return numbersIn(rows, column + 2).areWithin(-minutesInDegree, minutesInDegree) ? 3 : 2;
}

}  // namespace alidade
