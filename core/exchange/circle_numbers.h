#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// The numbers in a column of the rows; `areAll`: no other text stands in it, and there is one at least.
struct ColumnNumbers {
  std::vector<double> values;
  bool areAll = false, areWhole = false;

  bool areWithin(double low, double high) const;  ///< all of them, `high` included
};
ColumnNumbers numbersIn(const std::vector<TableCells>& rows, std::size_t column);

/// How far the mean distance of the readings from the horizon is, were it there in either face.
double spreadAround(const std::vector<double>& vertical, double horizon);

/// Degrees or gon, whichever the readings can only be: by what is beyond 360, or lies around the horizon.
/// `all` are of both circles. Unstated where they do not tell.
AngleUnit unitByNumbers(const std::vector<double>& all, const std::vector<double>& vertical);

/// Columns side by side whose numbers are degrees, minutes and perhaps seconds: `count` is 2, 3, or 0 for
/// none.
std::size_t joinableAt(const std::vector<TableCells>& rows, std::size_t column);

}  // namespace alidade
