#pragma once

#include <optional>
#include <string>

#include "core/exchange/recognise.h"

namespace alidade::ui {

/// Remembers the last layout of the files of each signature (`Recognised::signature`). The present file
/// determines the separator, and also the unit and the decimal sign if the numbers show them.
class ImportMemory {
 public:
  /// Absent if there is no earlier layout, or the earlier layout does not fit the file.
  static std::optional<TableLayout> layoutOf(const Recognised& recognised);
  static void keep(const Recognised& recognised, const TableLayout& layout);
};

}  // namespace alidade::ui
