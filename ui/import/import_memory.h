#pragma once

#include <optional>
#include <string>

#include "core/exchange/recognise.h"

namespace alidade::ui {

/// The last layouts of similar files, by their signature. The present file takes precedence: its separator,
/// and unit and decimal sign if its numbers confirm them.
class ImportMemory {
 public:
  /// Absent without an earlier layout, or if it does not fit the file.
  static std::optional<TableLayout> layoutOf(const Recognised& recognised);
  static void keep(const Recognised& recognised, const TableLayout& layout);
};

}  // namespace alidade::ui
