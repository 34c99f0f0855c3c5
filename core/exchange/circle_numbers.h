#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/exchange/recording.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// The numbers in a column of the rows; `areAll`: the column has at least one number, and no other text.
struct ColumnNumbers {
  std::vector<double> values = {};
  std::size_t cells = 0;  ///< cells that are not empty
  bool areAll = false, areWhole = false;

  bool areWithin(double low, double high) const;  ///< all numbers lie in the range, `high` included
  bool areAtMost(double high) const;              ///< the numbers; other text does not count
  bool areMostlyWhole() const;                    ///< at least half of the cells are whole numbers
  bool areMostlyWithin(double low, double high) const;
};
ColumnNumbers numbersIn(const std::vector<TableCells>& rows, std::size_t column);

/// The mean distance of the readings from the horizon, at `horizon` in face 1 and 3 × `horizon` in face 2.
double spreadAround(const std::vector<double>& vertical, double horizon);

/// Gon if a reading in `all`, of both circles, exceeds 360. Else the unit whose horizon, 90° or 100 gon,
/// is less than half as far from the vertical readings as that of the other unit; else Unstated.
AngleUnit unitByNumbers(const std::vector<double>& all, const std::vector<double>& vertical);

/// Returns the number of adjacent columns from `column` on that hold degrees, minutes and perhaps seconds: 2
/// or 3, or 0 for none.
std::size_t joinableAt(const std::vector<TableCells>& rows, std::size_t column);

}  // namespace alidade
