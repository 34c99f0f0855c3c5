#pragma once

#include <optional>
#include <string>

#include "core/exchange/recognise.h"

namespace alidade::ui {

/// How files of one make were taken the last time, by their signature. What the file at hand tells by itself
/// counts: its separator, and unit and decimal sign where its numbers bear them out.
class ImportMemory {
 public:
  /// Absent where there was none, or where it does not fit the file.
  static std::optional<TableLayout> layoutOf(const Recognised& recognised);
  static void keep(const Recognised& recognised, const TableLayout& layout);
};

}  // namespace alidade::ui
