#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/exchange/file_format.h"
#include "core/exchange/table_layout.h"

namespace alidade {

/// Adjacent columns that may be the degrees, minutes and seconds of one angle.
struct JoinableColumns {
  std::size_t first = 0, count = 0;
  bool operator==(const JoinableColumns&) const = default;
};

/// The proposed format of a file of readings, judged by its beginning, with the reasons.
struct Recognised {
  const FileFormat* format = nullptr;     ///< a row of `fileFormats` that can be read; null: a table
  std::string name;                       ///< for people: "Leica GSI", "Table"
  TableLayout table;                      ///< proposal for a table; `columns` has a key for each column
  std::vector<std::string> titles;        ///< column names in the file; empty if it has none
  std::vector<JoinableColumns> joinable;  ///< columns that may form angles, in the order of the first
  bool saysAxis = false;                  ///< the file states the axis
  bool asksUnit = false;                  ///< the circles of a table are plain numbers without a named unit
  std::vector<std::string> reasons;       ///< sentences without a full stop that explain the proposal

  bool isTable() const { return format == nullptr; }

  /// A text that is equal for files of one origin: the choices for one file apply to the next file.
  std::string signature() const;
};

/// Recognises the first lines of a text (`readingsText`). Fails on empty texts and on formats that are named
/// but not read.
Result<Recognised> recognise(std::string_view text);

/// Are both circles among the columns?
bool hasCircles(const TableLayout& layout);

/// Recognises a table by its beginning. For `recognise`.
Recognised recogniseTable(std::string_view beginning);

}  // namespace alidade
