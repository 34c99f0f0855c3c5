#pragma once

#include <optional>
#include <string>

#include "core/exchange/recognise.h"

namespace alidade::ui {

/// The last layout of each kind of file, identified by its signature. The present file takes precedence for
/// its separator, and for unit and decimal sign if its numbers show them.
class ImportMemory {
 public:
  /// Absent without an earlier layout, or if it does not fit the file.
  static std::optional<TableLayout> layoutOf(const Recognised& recognised);
  static void keep(const Recognised& recognised, const TableLayout& layout);
};

}  // namespace alidade::ui
