#pragma once

#include <string>
#include <string_view>

#include "core/exchange/recording.h"
#include "core/exchange/table_layout.h"

namespace alidade {

/// Reads a table of rows (csv_table.h). Its columns, in any order, are named by their headings or by
/// `layout`: the fields of a row, and `axis` or `position`, 0 or 180. `turn` counts the repeats of a position
/// at its axis. Headings are those of heading_words.h, in six languages; they may span several columns and
/// rows (table_headings.h). Both circles are needed, unless the layout allows a table without the vertical
/// one. The apostrophe that protects a text from being read as a formula (csv_text.h) is removed. A cell may
/// say more than an entry of a session:
///
///   point: a name; ZERO, or `zeroPoint`, is the pointing zero
///   face: I, II, L, R, FL, FR, 盘左, КЛ, … (table_faces.h)
///   excluded: 1, yes, true or x; 0, no or false; empty: no
///
/// The degrees, minutes and seconds of an angle (or gon with their hundredths) may be in two or three columns
/// and are joined exactly. The table or row is refused if a part has no column or no value, or if whole
/// degrees are next to a column that may hold their minutes: degrees are never read alone. Columns of both
/// faces (Hz I, Hz II, V I, V II) are two sightings per row. Minutes and seconds of 60 carry; 360° and
/// 400 gon are 0.
///
/// A unit in a heading, `Hz [gon]` or `v_deg`, holds for the plain numbers of its column; otherwise the unit
/// of the layout holds. For `grad`, the numbers decide between degrees and gon. The vertical circle reads
/// elevations if a heading says `elevation`, or if no heading names its kind and readings near the horizon
/// are negative. If the layout states the decimal sign, circle readings with the other sign are refused.
/// Two columns for one field are refused; an ambiguous heading (`H`, `No`) gives way to a clear one.
/// `unused` lists other columns, rows of means, rows without a reading, and lines that begin with # and hold
/// readings of both circles.
Recording readTable(std::string_view text, const TableLayout& layout, const std::string& zeroPoint = {});

}  // namespace alidade
