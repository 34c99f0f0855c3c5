#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/file_format.h"
#include "core/exchange/table_layout.h"

namespace alidade {

/// Columns side by side that may be the degrees, minutes and seconds of one angle.
struct JoinableColumns {
  std::size_t first = 0, count = 0;
  bool operator==(const JoinableColumns&) const = default;
};

/// What a file of readings looks to be, from its beginning: a proposal with its reasons.
struct Recognised {
  const FileFormat* format = nullptr;  ///< a row of `fileFormats` that is read; null: a table
  std::string name;                    ///< for people: "Leica GSI", "Table"
  TableLayout table;                   ///< of a table, as proposed: its `columns` are one key for each
  std::vector<std::string> titles;  ///< of a table's columns as the file names them; empty where it does not
  std::vector<JoinableColumns> joinable;  ///< of a table, in the order of their first
  bool saysAxis = false;                  ///< how the axis stood stands in the file
  bool asksUnit = false;                  ///< of a table: circles hold plain numbers and no name says of what
  std::vector<std::string> reasons;       ///< sentences without their full stop: why it is taken so

  bool isTable() const { return format == nullptr; }

  /// The same for files of the same make: what was chosen for one goes for the next.
  std::string signature() const;
};

/// From the first lines of a text (`readingsText`). Fails on what holds nothing, and on formats that are
/// named and not read.
Result<Recognised> recognise(std::string_view text);

/// Are both circles among the columns?
bool hasCircles(const TableLayout& layout);

}  // namespace alidade
