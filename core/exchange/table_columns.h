#pragma once

#include <string>
#include <vector>

#include "core/exchange/recognise.h"
#include "core/exchange/table_plan.h"

namespace alidade {

/// Could the cell be a circle reading, once its unit is known?
bool mayBeAngle(const std::string& cell);
/// Does the cell have a decimal sign, or is it an angle with signs or separators?
bool hasDecimals(const std::string& cell);

/// Guesses the columns of a table without names, as keys of `TableLayout::columns`. The circles are two
/// adjacent groups of degrees, minutes and seconds, or else the first two columns of angles with decimals;
/// the horizontal circle comes first. Before the circles, a column of 0 and 180 is the axis, one of 1 and 2
/// the face, another one the point. False if two circles cannot be found.
bool guessColumns(const std::vector<TableCells>& rows, std::vector<std::string>& columns);

/// The groups of columns that together hold one angle, by the keys of the columns.
std::vector<JoinableColumns> joinedColumns(const std::vector<std::string>& columns);

}  // namespace alidade
