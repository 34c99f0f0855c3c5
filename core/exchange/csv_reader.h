#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"

namespace alidade {

/// Reads a table of readings (csv_table.h) whose first row names the columns, in any order:
///
///   horizontal   Hz, H, α, direction                  circle reading; needed
///   vertical     V, β, zenith, elevation              circle reading; needed
///   axis         position, pos                        0 or 180
///   point        point no, pt, no, number, target     whole number or name; ZERO, or `zeroPoint`, is the
///                                                     pointing zero
///   round        set, series                          face   side; 1, 2, I, II, L, R, left, right
///   slider       s                                    note   remark, comment
///   excluded     skip                                 1, yes, true or x; 0, no or false; empty: no
///
/// Capitals, blanks, _ and words such as “angle”, “circle” and “reading” do not matter. A unit in a name,
/// `Hz [gon]` or `v_deg`, holds for the plain numbers of its column; otherwise `unit` does. `elevation` says
/// that the vertical circle reads elevations. Other columns are listed in `unused`, and so are lines that
/// begin with # where both circles are read in them.
Recording readCsv(std::string_view text, AngleUnit unit = AngleUnit::Unstated,
                  const std::string& zeroPoint = {});

}  // namespace alidade
