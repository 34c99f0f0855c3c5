#include "core/exchange/table_columns.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/exchange/circle_numbers.h"

namespace alidade {

namespace {

/// The first columns of the two circles, and how many columns each has.
struct CircleColumns {
  std::size_t horizontal = 0, vertical = 0, count = 1;
};

std::set<std::string> valuesOf(const std::vector<TableCells>& rows, std::size_t column) {
  std::set<std::string> values;
  for (const TableCells& row : rows)
    if (column < row.size()) values.insert(row[column]);
  return values;
}

/// Are more than half of the column's entries angles with decimals or signs?
bool holdsAngles(const std::vector<TableCells>& rows, std::size_t column) {
  std::size_t count = 0, all = 0;
  for (const TableCells& row : rows) {
    if (column >= row.size() || row[column].empty()) continue;
    ++all;
    count += hasDecimals(row[column]) && mayBeAngle(row[column]) ? 1 : 0;
  }
  return 2 * count > all;
}

/// Two adjacent groups of degrees, minutes and perhaps seconds. The last two such groups are the circles:
/// earlier columns may match by chance.
std::optional<CircleColumns> joinedCircles(const std::vector<TableCells>& rows, std::size_t width) {
  for (const std::size_t count : {std::size_t{3}, std::size_t{2}})
    for (std::size_t at = width; at-- > 0;) {
      const std::size_t other = at + count;
      if (other + count > width) continue;
      const bool areParts = joinableAt(rows, at) == count && joinableAt(rows, other) == count;
      if (areParts) return CircleColumns{at, other, count};
    }
  return std::nullopt;
}

/// May the column be the minutes or seconds of an angle whose degrees are in an earlier column?
bool mayBePart(const std::vector<TableCells>& rows, std::size_t column) {
  return column > 0 &&
         (joinableAt(rows, column - 1) > 0 || (column > 1 && joinableAt(rows, column - 2) == 3));
}

std::optional<CircleColumns> circlesOf(const std::vector<TableCells>& rows, std::size_t width,
                                       std::vector<std::string>& columns) {
  const auto joined = joinedCircles(rows, width);
  std::vector<std::size_t> angles;
  for (std::size_t i = 0; i < width; ++i)
    if (holdsAngles(rows, i)) angles.push_back(i);
  const bool areWhole = angles.size() >= 2 && !(mayBePart(rows, angles[0]) && mayBePart(rows, angles[1]));
  if (joined && !areWhole) return joined;
  if (angles.size() < 2) return std::nullopt;
  if (angles.size() > 2) columns[angles[2]] = "slider";
  return CircleColumns{angles[0], angles[1], 1};
}

void enterCircle(std::vector<std::string>& columns, std::size_t at, std::size_t count,
                 std::string Reading::*circle) {
  for (std::size_t i = 0; i < count; ++i)
    columns[at + i] = TableColumn{.field = &rowField(circle), .part = static_cast<AnglePart>(i)}.key();
}

}  // namespace

bool mayBeAngle(const std::string& cell) {
  constexpr double beyond = 400;
  if (const auto number = parseNumber(cell)) return std::abs(*number) < beyond;
  return static_cast<bool>(parseAngle(cell));
}

bool hasDecimals(const std::string& cell) {
  return cell.find_first_of(".,") != std::string::npos || (!parseNumber(cell) && parseAngle(cell));
}

bool guessColumns(const std::vector<TableCells>& rows, std::vector<std::string>& columns) {
  const auto circles = circlesOf(rows, columns.size(), columns);
  if (!circles) return false;
  enterCircle(columns, circles->horizontal, circles->count, &Reading::horizontal);
  enterCircle(columns, circles->vertical, circles->count, &Reading::vertical);
  for (std::size_t i = 0; i < circles->horizontal; ++i) {
    const std::set<std::string> values = valuesOf(rows, i);
    const auto areOf = [&values](const std::set<std::string>& allowed) {
      return !values.empty() && std::includes(allowed.begin(), allowed.end(), values.begin(), values.end());
    };
    const auto isFree = [&columns](const char* key) {
      return std::find(columns.begin(), columns.end(), key) == columns.end();
    };
    if (areOf({"0", "180"}) && isFree("axis") && values.contains("180")) {
      columns[i] = "axis";
    } else if (areOf({"1", "2"}) && i > 0 && isFree("face")) {
      columns[i] = "face";
    } else if (isFree("point")) {
      columns[i] = "point";
    }
  }
  return true;
}

std::vector<JoinableColumns> joinedColumns(const std::vector<std::string>& columns) {
  std::vector<JoinableColumns> joined;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto follows = [&](std::size_t count, const char* ending) {
      return i + count < columns.size() && columns[i + count] == columns[i] + ending;
    };
    if (columns[i].empty() || !follows(1, "_minutes")) continue;
    joined.push_back({i, follows(2, "_seconds") ? std::size_t{3} : std::size_t{2}});
  }
  return joined;
}

}  // namespace alidade
