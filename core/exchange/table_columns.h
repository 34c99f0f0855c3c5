#pragma once

#include <string>
#include <vector>

#include "core/exchange/recognise.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// Could it be a reading of a circle, once its unit is known?
bool mayBeAngle(const std::string& cell);
/// A number with decimals, or an angle with signs.
bool hasDecimals(const std::string& cell);

/// What the columns of a table without names may hold, as keys of `TableLayout::columns`. The circles are
/// degrees, minutes and seconds in columns side by side, twice, or else the first two columns of angles with
/// decimals, horizontal first; a column of 0 and 180 before them is the axis, one of 1 and 2 the face,
/// another the point. False where there are no two circles.
bool guessColumns(const std::vector<TableCells>& rows, std::vector<std::string>& columns);

/// Which of the columns hold one angle together, by their keys.
std::vector<JoinableColumns> joinedColumns(const std::vector<std::string>& columns);

}  // namespace alidade
