#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"
#include "core/exchange/table_layout.h"

namespace alidade {

/// Reads a table of rows (csv_table.h) whose columns are named by its first row, in any order, or by
/// `layout`: the fields of a row, each by one of its `headings` (row_fields.h), and `axis` or `position`, 0
/// or 180. `turn` is the how many-th position at its axis. Both circles are needed. An
/// apostrophe that kept a spreadsheet from taking a text for a formula (csv_text.h) is taken off. A cell may
/// say more than an entry of a session:
///
///   point      a name; ZERO, or `zeroPoint`, is the pointing zero; the column may be called `no` or `number`
///   face       I, II, L, R, left, right
///   excluded   1, yes, true or x; 0, no or false; empty: no
///
/// A unit in a name, `Hz [gon]` or `v_deg`, holds for the plain numbers of its column; otherwise that of the
/// layout does. `elevation` says that the vertical circle reads elevations. Where the layout states the
/// decimal sign, a circle's number with the other one is refused. Other columns are listed in `unused`, and
/// so are lines that begin with # where both circles are read in them.
Recording readTable(std::string_view text, const TableLayout& layout, const std::string& zeroPoint = {});

/// As its first row names the columns.
Recording readCsv(std::string_view text, AngleUnit unit = AngleUnit::Unstated,
                  const std::string& zeroPoint = {});

}  // namespace alidade
