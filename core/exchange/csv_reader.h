#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"
#include "core/exchange/table_layout.h"

namespace alidade {

/// Reads a table of rows (csv_table.h) whose columns are named by their headings, in any order, or by
/// `layout`: the fields of a row, and `axis` or `position`, 0 or 180. `turn` is the how many-th position at
/// its axis. Headings are those of heading_words.h, in six languages; they may reach over several columns and
/// rows (table_headings.h). Both circles are needed, but where the layout does without the vertical one. An
/// apostrophe that kept a spreadsheet from taking a text for a formula (csv_text.h) is taken off. A cell may
/// say more than an entry of a session:
///
///   point      a name; ZERO, or `zeroPoint`, is the pointing zero
///   face       I, II, L, R, FL, FR, 盘左, КЛ, … (table_faces.h)
///   excluded   1, yes, true or x; 0, no or false; empty: no
///
/// An angle may stand in two or three columns, its degrees, minutes and seconds (or gon with their
/// hundredths), and is joined exactly; where a part has no column or no value, or whole degrees stand beside
/// a column that may be their minutes, the table or the row is refused: never are the degrees read alone.
/// Columns of both faces (Hz I, Hz II, V I, V II) are two sightings a row. Minutes and seconds of 60 carry,
/// 360° and 400 gon are 0.
///
/// A unit in a heading, `Hz [gon]` or `v_deg`, holds for the plain numbers of its column; otherwise that of
/// the layout does. `grad` is degrees or gon as the numbers tell. `elevation` says that the vertical circle
/// reads elevations, and so do negative readings near the horizon where no heading says it. Where the layout
/// states the decimal sign, a circle's number with the other one is refused. Two columns for one field are
/// refused; a heading that may mean several things
/// (`H`, `No`) gives way to one that does not. Listed in `unused` are other columns, rows of means and rows
/// without a reading, and lines that begin with # where both circles are read in them.
Recording readTable(std::string_view text, const TableLayout& layout, const std::string& zeroPoint = {});

/// As its first row names the columns.
Recording readCsv(std::string_view text, AngleUnit unit = AngleUnit::Unstated,
                  const std::string& zeroPoint = {});

}  // namespace alidade
